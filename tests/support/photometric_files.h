// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/photometry/read_photometry.h"

namespace luxel {

// A small IES file, of which tests change parts: 1000 cd down, 500 cd at 60 degrees, none at 90.
struct MadeIes {
  std::string tag = "IESNA:LM-63-2002\n", labels = "[MANUFAC] Maker\n", tilt = "TILT=NONE\n";
  std::string lamps = "1 10000 1", type = "1", units = "2", size = "0 0 0", ballast = "1 1 20";
  std::string vertical = "0 60 90", horizontal = "0", candela = "1000 500 0";

  std::string text() const {
    return fmt::format("{}{}{}{} {} {} {} {} {}\n{}\n{}\n{}\n{}\n", tag, labels, tilt, lamps, count(vertical),
                       count(horizontal), type, units, size, ballast, vertical, horizontal, candela);
  }
  Photometry read(const PhotometryOptions& options = {}) const {
    return read_photometry(text(), "made.ies", options);
  }

  static std::size_t count(const std::string& numbers) {
    return 1 + static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), ' '));
  }
};

// A small EULUMDAT file, of which tests change parts: the lines of the header by their numbers.
struct MadeLdt {
  std::vector<std::string> header = {"Maker", "1",    "1",    "1",   "0",  "3",  "0", "R1", "Luminaire",
                                     "L1",    "made", "date", "600", "0",  "80", "0", "0",  "0",
                                     "0",     "0",    "0",    "100", "80", "1",  "0", "1"};
  std::vector<std::string> lamps = {"1", "LED", "2000", "4000", "80", "20"};
  std::vector<std::string> c = {"0"}, gamma = {"0", "60", "90"}, values = {"100", "50", "0"};

  // Line of the header, from 1.
  std::string& line(std::size_t number) { return header[number - 1]; }
  void set_planes(int symmetry, const std::vector<std::string>& angles) {
    line(3) = std::to_string(symmetry);
    line(4) = std::to_string(angles.size());
    c = angles;
  }
  std::string text(const std::string& end = "\r\n") const {
    std::string all;
    const std::vector<std::string> ratios(10, "0.5");
    for (const auto* lines : {&header, &lamps, &ratios, &c, &gamma, &values})
      for (const auto& l : *lines) all += l + end;
    return all;
  }
  Photometry read(const PhotometryOptions& options = {}) const {
    return read_photometry(text(), "made.ldt", options);
  }
};

// The message with which a file is refused; empty: it is read.
inline std::string refusal(const std::string& text, const PhotometryOptions& options = {}) {
  try {
    read_photometry(text, "made.ies", options);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// The warnings as one text.
inline std::string warnings_of(const Photometry& photometry) {
  std::string all;
  for (const auto& warning : photometry.warnings) all += warning + "\n";
  return all;
}

}  // namespace luxel
