#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "table/input.h"

namespace twrench::table {

/// A file in a ZIP archive.
struct ZipMember {
  std::string name;
  std::uint64_t index = 0;  ///< in the archive
  std::uint64_t size = 0;   ///< bytes when unpacked
};

/// A ZIP archive whose members are unpacked piece by piece. The input must outlive it.
class ZipArchive {
 public:
  /// Throws system::FileError if it is cut off, damaged or too large.
  explicit ZipArchive(const Input& input);
  ~ZipArchive();
  ZipArchive(ZipArchive&&) noexcept;
  ZipArchive& operator=(ZipArchive&&) noexcept;

  const std::vector<ZipMember>& members() const { return members_; }

  /// Unpacks a member from its beginning on.
  class Stream {
   public:
    ~Stream();
    Stream(Stream&&) noexcept;
    Stream& operator=(Stream&&) noexcept;

    /// Unpacks up to `length` bytes, and returns how many: fewer only at the end, where the
    /// checksum is compared. Throws system::FileError if it cannot be unpacked.
    std::size_t read(char* to, std::size_t length);

   private:
    friend class ZipArchive;
    struct State;
    explicit Stream(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
  };

  /// Throws system::FileError if the member is encrypted, packed by a method that is not supported,
  /// or has a size that its packed bytes cannot have. The archive must outlive the stream.
  Stream open(const ZipMember& member) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::vector<ZipMember> members_;
};

}  // namespace twrench::table
