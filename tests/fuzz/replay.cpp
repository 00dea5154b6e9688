// replay CORPUS COUNT: runs the target on each file of the corpus, then on COUNT mutations of them,
// the same ones every time, so that fixed bugs stay fixed without a fuzzer at hand.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <vector>

#include "system/file.h"
#include "target.h"

namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> read_corpus(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  constexpr std::size_t longest = 1 << 20;
  std::vector<Bytes> corpus;
  for (const auto& path : paths) corpus.push_back(twrench::system::read_file(path, longest));
  return corpus;
}

/// Changes, duplicates or removes a few bytes, or replaces the end by that of another input.
Bytes mutated(Bytes bytes, const Bytes& other, std::mt19937& random) {
  // Not std::uniform_int_distribution, which differs between libraries.
  const auto below = [&](std::size_t n) { return random() % std::max<std::size_t>(n, 1); };
  for (std::size_t i = 1 + below(4); i > 0; --i) {
    const auto at = static_cast<std::ptrdiff_t>(below(bytes.size() + 1));
    const auto length = static_cast<std::ptrdiff_t>(
        std::min(bytes.size() - static_cast<std::size_t>(at), 1 + below(16)));
    const auto begin = bytes.begin() + at;
    switch (below(5)) {
      case 0:
        std::fill(begin, begin + std::min<std::ptrdiff_t>(length, 1),
                  static_cast<std::uint8_t>(random()));
        break;
      case 1:
        std::for_each(begin, begin + std::min<std::ptrdiff_t>(length, 1), [&](std::uint8_t& byte) {
          byte ^= static_cast<std::uint8_t>(1U << below(8));
        });
        break;
      case 2: {
        const Bytes piece(begin, begin + length);
        bytes.insert(begin, piece.begin(), piece.end());
        break;
      }
      case 3:
        bytes.erase(begin, begin + length);
        break;
      default:
        bytes.resize(static_cast<std::size_t>(at));
        bytes.insert(bytes.end(),
                     other.begin() + static_cast<std::ptrdiff_t>(
                                         std::min(static_cast<std::size_t>(at), other.size())),
                     other.end());
    }
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " CORPUS COUNT\n";
    return EXIT_FAILURE;
  }
  const std::vector<Bytes> corpus = read_corpus(argv[1]);
  if (corpus.empty()) return EXIT_FAILURE;
  for (const Bytes& input : corpus) LLVMFuzzerTestOneInput(input.data(), input.size());
  std::mt19937 random(20201);
  const long count = std::strtol(argv[2], nullptr, 10);
  for (long i = 0; i < count; ++i) {
    const Bytes& input = corpus[random() % corpus.size()];
    const Bytes& other = corpus[random() % corpus.size()];
    const Bytes changed = mutated(input, other, random);
    LLVMFuzzerTestOneInput(changed.data(), changed.size());
  }
  std::cout << corpus.size() << " kept inputs and " << count << " mutations\n";
}
