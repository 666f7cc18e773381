// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "luxel/cli/console.h"
#include "luxel/runs/settings.h"

namespace luxel {

// A result that is a table: of points or of observers.
struct TableResult {
  std::string label;    // of the summary: "probe"
  std::string summary;  // for a person
  std::vector<std::string> warnings;
  std::function<std::string()> csv;
  std::function<std::string(const std::vector<std::string>& outputs)> json;
  // Writes a file of a kind other than .csv and .json; returns false for an unknown kind.
  std::function<bool(const std::string& output)> other = {};
};

// Writes the outputs of -o by their extensions and the file of --json-file, reports the summary and the
// warnings, and prints the JSON, the names of the outputs, or where there are none the CSV. Throws
// DeviceError.
void write_table(const TableResult& result, const RunSettings& run, Console& console);

}  // namespace luxel
