#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace twrench::archive {

/// The bytes of an archive, which are read piece by piece.
struct ZipBytes {
  /// The name in messages.
  std::string name;
  std::uint64_t size = 0;
  /// Copies up to `length` bytes from `offset` on, and returns how many: fewer only at the end.
  std::function<std::size_t(std::uint64_t offset, char* to, std::size_t length)> read;
  /// What helps if the archive is damaged: "write it again with numpy.savez".
  std::string remedy;
};

/// A file in a ZIP archive.
struct ZipMember {
  std::string name;
  std::uint64_t index = 0;  ///< in the archive
  std::uint64_t size = 0;   ///< bytes when unpacked
};

/// A ZIP archive whose members are unpacked piece by piece.
class ZipArchive {
 public:
  /// Throws system::FileError if it is cut off, damaged or too large, and what `bytes.read` throws.
  explicit ZipArchive(ZipBytes bytes);
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

}  // namespace twrench::archive
