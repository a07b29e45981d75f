#pragma once
// What can fail because of the outside world (files, presets, numbers a person typed) returns Result<T>: a value, or an
// Error whose text is one sentence for that person. A broken invariant of our own is an assertion, never a Result.

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace glint {

enum class ErrorKind {
  request,  ///< the words or numbers of the request are off (exit status 2)
  content,  ///< the request is well formed; a file's content or the machine does not allow it (exit status 1)
};

struct Error {
  ErrorKind kind = ErrorKind::content;
  std::string subject;   ///< the file, option or field it is about
  std::string sentence;  ///< what is wrong and what would be right; no trailing full stop, no line break

  [[nodiscard]] std::string message() const { return subject.empty() ? sentence : subject + ": " + sentence; }
};

[[nodiscard]] inline Error request_error(std::string subject, std::string sentence) {
  return {ErrorKind::request, std::move(subject), std::move(sentence)};
}
[[nodiscard]] inline Error content_error(std::string subject, std::string sentence) {
  return {ErrorKind::content, std::move(subject), std::move(sentence)};
}

/// A value or an Error. Converts from either; ask with `if (result)` before taking the value.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT: implicit by design, so that `return value;` works
  Result(Error error) : state_(std::move(error)) {}  // NOLINT: likewise `return error;`

  explicit operator bool() const { return std::holds_alternative<T>(state_); }
  T& value() & { return assert(*this), std::get<T>(state_); }
  const T& value() const& { return assert(*this), std::get<T>(state_); }
  T&& value() && { return assert(*this), std::get<T>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return assert(!*this), std::get<Error>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
using Status = Result<std::monostate>;
[[nodiscard]] inline Status success() {
  return std::monostate{};
}

}  // namespace glint
