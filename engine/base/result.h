// What a user can get wrong comes back as an Error with its place; what only we can get wrong is a
// CHECK (check.h).
//
// Result<T> holds a value or an Error. Nothing here throws.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace glint {

/// Where in a user's file something is wrong. line and column count from 1; 0 means "not known".
struct SourcePlace {
    std::string file;
    int line = 0;
    int column = 0;
    std::string lineText{};  ///< the whole offending line, empty when not known or not text
};

/// Why something the user asked for cannot be done: what is wrong and what was expected, in one sentence.
struct Error {
    std::string message;
    SourcePlace place;

    /// `file:line:column: message`, and below it the line with a caret where both are known. Long lines
    /// are cut around the caret and control characters are replaced, so that binary input cannot garble
    /// a terminal.
    std::string format() const;
};

template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() & { return std::get<0>(state_); }
    const T& value() const& { return std::get<0>(state_); }
    T&& value() && { return std::get<0>(std::move(state_)); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    const Error& error() const { return std::get<1>(state_); }

  private:
    std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    bool ok() const { return !error_.has_value(); }
    explicit operator bool() const { return ok(); }
    const Error& error() const { return *error_; }

  private:
    std::optional<Error> error_;
};

using Status = Result<void>;

}  // namespace glint
