// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "luxel/export/room_data.h"
#include "luxel/lighting/verdict.h"

namespace luxel {

// Common parts of the pages of reports: HTML of whole elements. Arguments are HTML, too, unless stated.

// The page up to the first section: head with style, title and the rows of names and values below it; values
// may be empty, then the row is left out. title and values: text.
std::string page_begin(const std::string& title, const std::string& version,
                       const std::vector<std::pair<std::string, std::string>>& rows);

std::string page_heading(const std::string& text);
std::string page_figure(const std::string& content, const std::string& caption);
// A number of the summary with its name and a note.
std::string page_box(const std::string& name, const std::string& value, const std::string& note);
// The words of a verdict in its colour.
std::string compliance_span(Compliance compliance);
// Size and materials of a room.
std::string room_tables(const RoomData& room);

}  // namespace luxel
