// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Numbers of EN 12464-1:2021 and EN 1838. The standards are sold and were not read: each row names where its
// numbers come from, and a client checks them against the edition of the contract. Numbers that no source
// states are left out.
//
// performanceinlighting.com: /ww/us/en-12464-1. glamox.com: /en-gb/pbs/application-guide/education/
// communal-and-circulation-areas-for-education. The others are those that designers use, without a page to
// cite, and are marked so.
inline constexpr const char* built_in_requirements = R"toml([requirement.writing]
source = "EN 12464-1:2021, offices: writing, typing, reading, data processing; not checked against the text of the standard"
Em = 500
U0 = 0.60
UGR = 19
Ra = 80
Ez = 150
E_wall = 150
E_ceiling = 100

[requirement.writing-modified]
source = "EN 12464-1:2021, offices: writing, two steps higher for demanding conditions; not checked against the text of the standard"
Em = 1000
U0 = 0.60
UGR = 19
Ra = 80
Ez = 150
E_wall = 150
E_ceiling = 100

[requirement.filing]
source = "EN 12464-1:2021, offices: filing, copying (as printed by performanceinlighting.com)"
Em = 300
U0 = 0.40
Ra = 80

[requirement.filing-modified]
source = "EN 12464-1:2021, offices: filing, copying, for demanding conditions (as printed by performanceinlighting.com)"
Em = 500
U0 = 0.40
Ra = 80

[requirement.technical-drawing]
source = "EN 12464-1:2021, offices: technical drawing; not checked against the text of the standard"
Em = 750
U0 = 0.70
UGR = 16
Ra = 80

[requirement.conference]
source = "EN 12464-1:2021, offices: conference and meeting rooms; not checked against the text of the standard"
Em = 500
U0 = 0.60
UGR = 19
Ra = 80

[requirement.reception]
source = "EN 12464-1:2021, offices: reception desk; not checked against the text of the standard"
Em = 300
U0 = 0.60
UGR = 22
Ra = 80

[requirement.archive]
source = "EN 12464-1:2021, offices: archiving; not checked against the text of the standard"
Em = 200
U0 = 0.40
UGR = 25
Ra = 80

[requirement.classroom]
source = "EN 12464-1:2021, education: classrooms; not checked against the text of the standard"
Em = 500
U0 = 0.60
UGR = 19
Ra = 80

[requirement.lecture-hall]
source = "EN 12464-1:2021, education: lecture halls; not checked against the text of the standard"
Em = 500
U0 = 0.60
UGR = 19
Ra = 80

[requirement.school-entrance]
source = "EN 12464-1:2021, education: entrance halls (as printed by glamox.com)"
Em = 200
U0 = 0.40
UGR = 22
Ra = 80
Ez = 75
E_wall = 75
E_ceiling = 50

[requirement.school-corridor]
source = "EN 12464-1:2021, education: circulation areas, corridors; at floor level (as printed by glamox.com)"
Em = 100
U0 = 0.40
UGR = 25
Ra = 80
Ez = 50
E_wall = 50
E_ceiling = 30

[requirement.school-stairs]
source = "EN 12464-1:2021, education: stairs; at floor level (as printed by glamox.com)"
Em = 150
U0 = 0.40
UGR = 25
Ra = 80
Ez = 50
E_wall = 50
E_ceiling = 30

[requirement.corridor]
source = "EN 12464-1:2021, inside buildings: circulation areas, corridors; at floor level; not checked against the text of the standard"
Em = 100
U0 = 0.40
UGR = 28
Ra = 40

[requirement.stairs]
source = "EN 12464-1:2021, inside buildings: stairs; at floor level; not checked against the text of the standard"
Em = 100
U0 = 0.40
UGR = 25
Ra = 40

[requirement.canteen]
source = "EN 12464-1:2021, inside buildings: canteens, pantries; not checked against the text of the standard"
Em = 200
U0 = 0.40
UGR = 22
Ra = 80

[requirement.washroom]
source = "EN 12464-1:2021, inside buildings: cloakrooms, washrooms, toilets; not checked against the text of the standard"
Em = 200
U0 = 0.40
UGR = 25
Ra = 80

[requirement.store-room]
source = "EN 12464-1:2021, inside buildings: store and stock rooms; not checked against the text of the standard"
Em = 100
U0 = 0.40
UGR = 25

[requirement.escape-route]
source = "EN 1838: centre line of an escape route (as TRILUX and ETAP print it)"
Emin = 1
max_over_min = 40

[requirement.anti-panic]
source = "EN 1838: open area, without a rim of 0.5 m (as TRILUX and ETAP print it)"
Emin = 0.5
max_over_min = 40
)toml";

}  // namespace luxel
