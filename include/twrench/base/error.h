#pragma once

#include <stdexcept>
#include <string>
#include <utility>

// The errors that the library throws. They state which quantity is wrong and why. The program maps
// the quantity to its option and chooses the exit code.

namespace twrench {

// The destructors are defined in the library, so that the type information with which a handler
// matches an error exists only there.

/// A failure that a caller can act on. what() is "WHAT: WHY", on one line.
class Error : public std::runtime_error {
 public:
  /// `what` failed because of `why`; `remedy` may be empty. The texts may quote input of any length
  /// and content. The middle of a long text, and of a long quotation that is not a path, is
  /// omitted, and a NUL becomes an escape sequence.
  Error(const std::string& what, const std::string& why, const std::string& remedy = {});
  /// Copies it.
  Error(const Error&) = default;
  /// Copies it.
  Error& operator=(const Error&) = default;
  ~Error() override;

  /// Returns the remedy, worded for any caller; may be empty.
  const std::string& remedy() const noexcept { return remedy_; }

 protected:
  /// Returns `what` as it appears in the message.
  static std::string quoted(const std::string& what);

 private:
  std::string remedy_;
};

/// A value that is not allowed, or an unknown name.
class InvalidArgument : public Error {
 public:
  /// `quantity` names the value, `why` explains why it is not allowed; `remedy` may be empty.
  InvalidArgument(const std::string& quantity, const std::string& why,
                  const std::string& remedy = {})
      : Error(quantity, why, remedy), quantity_(quoted(quantity)) {}
  /// Copies it.
  InvalidArgument(const InvalidArgument&) = default;
  /// Copies it.
  InvalidArgument& operator=(const InvalidArgument&) = default;
  ~InvalidArgument() override;

  /// Returns the name of the value at its source: "inertia", "scene.toml:3: motion.step".
  const std::string& quantity() const noexcept { return quantity_; }

 private:
  std::string quantity_;
};

/// A number outside its bounds.
class OutOfRange : public InvalidArgument {
 public:
  /// A value and its allowed range, which includes the bounds unless the message says otherwise.
  struct Range {
    double value;     ///< the value itself
    double least;     ///< the lower bound; minus infinity if there is none
    double greatest;  ///< the upper bound; infinity if there is none
  };

  /// `quantity` names the number, `why` explains why it is not allowed; `remedy` may be empty.
  OutOfRange(const std::string& quantity, const std::string& why, const Range& range,
             const std::string& remedy = {})
      : InvalidArgument(quantity, why, remedy), range_(range) {}
  /// Copies it.
  OutOfRange(const OutOfRange&) = default;
  /// Copies it.
  OutOfRange& operator=(const OutOfRange&) = default;
  ~OutOfRange() override;

  /// Returns the value.
  double value() const noexcept { return range_.value; }
  /// Returns the lower bound; minus infinity if there is none.
  double least() const noexcept { return range_.least; }
  /// Returns the upper bound; infinity if there is none.
  double greatest() const noexcept { return range_.greatest; }

 private:
  Range range_;
};

}  // namespace twrench
