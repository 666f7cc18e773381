// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/read_spectra.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/csv_table.h"
#include "luxel/import/numbers.h"
#include "luxel/import/text.h"

namespace luxel {
namespace {

using Quantity = MeasuredSpectrum::Quantity;

constexpr std::string_view header = "material,quantity,wavelength_nm,value";
constexpr double longest_wavelength = 1e6;  // nm; a longer one is not in nanometres
constexpr double max_radiance = 1e12;       // W/(m² sr nm)

struct Row {
  std::size_t line = 0;
  double wavelength = 0.0, value = 0.0;
};

// Iterates over the non-empty lines of a text.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  bool next() {
    while (!rest_.empty()) {
      const auto end = rest_.find_first_of("\r\n");
      text_ = trim(rest_.substr(0, end));
      ++line_;
      auto taken = end == std::string_view::npos ? rest_.size() : end + 1;
      if (taken < rest_.size() && rest_[taken - 1] == '\r' && rest_[taken] == '\n') ++taken;
      rest_.remove_prefix(taken);
      if (!text_.empty() && text_.front() != '#') return true;
    }
    return false;
  }
  std::string_view text() const { return text_; }
  std::size_t line() const { return line_; }

 private:
  std::string_view rest_, text_;
  std::size_t line_ = 0;
};

class SpectraReader {
 public:
  explicit SpectraReader(const std::filesystem::path& path)
      : source_(path.string()), text_(read_text(path, source_)), lines_(text_) {}

  std::vector<MeasuredSpectrum> read() {
    if (!lines_.next()) refuse(fmt::format("expected the line '{}', found nothing", header));
    if (lower_case(lines_.text()) != header)
      refuse(fmt::format("expected the line '{}', found '{}'", header, excerpt(lines_.text())));
    while (lines_.next()) take_row();
    if (spectra_.empty()) throw InputError(source_, "expected at least one spectrum, found none");
    for (std::size_t i = 0; i < spectra_.size(); ++i) finish(spectra_[i], rows_[i]);
    return std::move(spectra_);
  }

 private:
  [[noreturn]] void refuse(const std::string& sentence) const {
    throw InputError(source_, std::max<std::size_t>(1, lines_.line()), sentence);
  }

  Quantity quantity(const std::string& word) const {
    if (word == "reflectance") return Quantity::reflectance;
    if (word == "radiance") return Quantity::radiance;
    if (word == "sky") return Quantity::sky;
    refuse(fmt::format("expected the quantity reflectance, radiance or sky, found '{}'", excerpt(word)));
  }

  double number(const std::string& word, const char* what, double least, double most,
                const char* unit) const {
    const auto value = read_precise_number(word);
    if (value && *value >= least && *value <= most) return *value;
    refuse(
        fmt::format("expected a {} from {:g} to {:g}{}, found '{}'", what, least, most, unit, excerpt(word)));
  }

  void take_row() {
    const auto words =
        csv_fields(lines_.text(), ',', [this](const std::string& sentence) { refuse(sentence); });
    if (words.size() != 4) refuse(fmt::format("expected 4 fields ({}), found {}", header, words.size()));
    const auto what = quantity(words[1]);
    if (what == Quantity::sky && !words[0].empty())
      refuse(fmt::format("expected no material for the sky, found '{}'", excerpt(words[0])));
    if (what != Quantity::sky && words[0].empty()) refuse("expected the name of a material, found none");
    const Row row{lines_.line(), number(words[2], "wavelength", 1.0, longest_wavelength, " nm"),
                  what == Quantity::reflectance
                      ? number(words[3], "reflectance", 0.0, 1.0, "")
                      : number(words[3], "radiance", 0.0, max_radiance, " W/(m² sr nm)")};
    const auto [found, is_new] = index_.try_emplace({words[0], what}, spectra_.size());
    if (is_new) {
      spectra_.push_back({words[0], what, {}, row.line});
      rows_.emplace_back();
    }
    rows_[found->second].push_back(row);
  }

  void finish(MeasuredSpectrum& measured, std::vector<Row>& rows) const {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& a, const Row& b) { return a.wavelength < b.wavelength; });
    std::vector<Spectrum::Sample> samples;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i > 0 && rows[i].wavelength == rows[i - 1].wavelength)
        throw InputError(source_, rows[i].line,
                         fmt::format("expected one value a wavelength, found {} nm again (first on line {})",
                                     rows[i].wavelength, rows[i - 1].line));
      samples.push_back({rows[i].wavelength, rows[i].value});
    }
    if (measured.quantity != Quantity::reflectance && samples.size() < 2)
      throw InputError(source_, measured.line, "expected a radiance at two wavelengths or more, found one");
    measured.spectrum = Spectrum(std::move(samples));
  }

  std::string source_, text_;
  Lines lines_;
  std::vector<MeasuredSpectrum> spectra_;
  std::vector<std::vector<Row>> rows_;  // of each spectrum
  std::map<std::pair<std::string, Quantity>, std::size_t> index_;
};

}  // namespace

std::vector<MeasuredSpectrum> read_spectra(const std::filesystem::path& path) {
  return SpectraReader(path).read();
}

}  // namespace luxel
