#include "check/thinned_rows.h"

#include <string>

#include "check/row_decoder.h"
#include "check/row_reader.h"

namespace twrench::check {

namespace {

constexpr std::size_t enough = 128, of_the_first = 4096;

}  // namespace

std::vector<Row> thinned_rows(const std::filesystem::path& file, const Convention& convention,
                              std::size_t most, std::size_t of) {
  RowReader reader(file, convention);
  ThinnedRows<Row> thinned(most);
  Row row;
  for (std::size_t i = 0; i < of && reader.next(row); ++i) thinned.add(row);
  return thinned.rows();
}

std::vector<Row> telling_rows(const std::filesystem::path& file, const Convention& convention) {
  return thinned_rows(file, convention, enough, of_the_first);
}

TellingNumbers telling_numbers(const std::filesystem::path& file, const Convention& convention) {
  const auto table = table::open_table(file);
  const RowDecoder decoder(table->header(), convention, [] { return std::string(); });
  table->select(decoder.columns());
  ThinnedRows<std::vector<table::Number>> thinned(enough);
  std::vector<table::Number> numbers(decoder.columns().size());
  for (std::size_t i = 0; i < of_the_first && table->next(numbers); ++i) thinned.add(numbers);
  return {table->header(), decoder.columns(), thinned.rows()};
}

}  // namespace twrench::check
