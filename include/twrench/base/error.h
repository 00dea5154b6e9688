#pragma once

#include <stdexcept>
#include <string>
#include <utility>

// The failures that callers are told of. They say what is wrong with which quantity; which option
// of a program the quantity came from, and how the program then ends, is the program's affair.

namespace twrench {

// The destructors are defined in the library, so that it alone has the tables by which a handler
// recognises an error.

/// A failure that a caller can act on. what() is "WHAT: WHY", on one line.
class Error : public std::runtime_error {
 public:
  /// `what` failed because of `why`; `remedy` may be empty. The texts may quote input of any length
  /// and content. A long text loses its middle, and a NUL becomes an escape sequence.
  Error(const std::string& what, const std::string& why, const std::string& remedy = {});
  /// Copies it.
  Error(const Error&) = default;
  /// Copies it.
  Error& operator=(const Error&) = default;
  ~Error() override;

  /// What can be done about it, whoever calls; may be empty.
  const std::string& remedy() const noexcept { return remedy_; }

 protected:
  /// Returns `what` as the message quotes it.
  static std::string quoted(const std::string& what);

 private:
  std::string remedy_;
};

/// A value that is not allowed, or a name that nothing has.
class InvalidArgument : public Error {
 public:
  /// What the value is called, why it is not allowed, and the remedy, if there is one.
  InvalidArgument(const std::string& quantity, const std::string& why,
                  const std::string& remedy = {})
      : Error(quantity, why, remedy), quantity_(quoted(quantity)) {}
  /// Copies it.
  InvalidArgument(const InvalidArgument&) = default;
  /// Copies it.
  InvalidArgument& operator=(const InvalidArgument&) = default;
  ~InvalidArgument() override;

  /// What the value is called where it was given: "inertia", "scene.toml:3: motion.step".
  const std::string& quantity() const noexcept { return quantity_; }

 private:
  std::string quantity_;
};

/// A number outside its bounds.
class OutOfRange : public InvalidArgument {
 public:
  /// What a number is, and what it may be, the bounds included unless the message says otherwise.
  struct Range {
    double value;     ///< what it is
    double least;     ///< the lower bound; minus infinity where there is none
    double greatest;  ///< the upper bound; infinity where there is none
  };

  /// What the number is called, why it is not allowed, and its range.
  OutOfRange(const std::string& quantity, const std::string& why, const Range& range,
             const std::string& remedy = {})
      : InvalidArgument(quantity, why, remedy), range_(range) {}
  /// Copies it.
  OutOfRange(const OutOfRange&) = default;
  /// Copies it.
  OutOfRange& operator=(const OutOfRange&) = default;
  ~OutOfRange() override;

  /// What the number is.
  double value() const noexcept { return range_.value; }
  /// The lower bound; minus infinity where there is none.
  double least() const noexcept { return range_.least; }
  /// The upper bound; infinity where there is none.
  double greatest() const noexcept { return range_.greatest; }

 private:
  Range range_;
};

}  // namespace twrench
