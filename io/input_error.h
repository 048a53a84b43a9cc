// What is wrong with a file that someone gave us, and where.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace brachium {

// what() reads `file:line: message`; the message says what was found and what was expected.
// Line 0: the file as a whole.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::size_t line, std::string message)
      : std::runtime_error(Located(file, line).append(": ").append(message)),
        file_(std::move(file)),
        line_(line),
        message_(std::move(message)) {}

  const std::string& file() const { return file_; }
  std::size_t line() const { return line_; }
  const std::string& message() const { return message_; }

 private:
  static std::string Located(std::string file, std::size_t line) {
    return line > 0 ? file.append(":").append(std::to_string(line)) : file;
  }

  std::string file_;
  std::size_t line_;
  std::string message_;
};

}  // namespace brachium
