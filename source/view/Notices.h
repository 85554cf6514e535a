#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace ray {

/// The message that the user reads, which fades as time passes, and what has changed since it was drawn.
class Notices {
 public:
  void Show(const std::string& message) {
    message_ = message;
    since_ = now_;
    question_.clear();
    needs_redraw_ = true;
  }
  const std::string& Message() const { return message_; }
  /// Asks for confirmation of an action that cannot be undone. Returns true if the action just before asked the same
  /// question and it is still visible; otherwise shows the question.
  bool Confirms(const std::string& question) {
    const bool is_answer = question == question_ && action_ == asked_at_ + 1 && Strength() > 0;
    if (!is_answer) Show(question);
    question_ = is_answer ? std::string() : question;
    asked_at_ = action_;
    return is_answer;
  }
  /// The user has pressed something.
  void CountAction() { ++action_; }
  /// The key that was pressed last has no function.
  void TakeBackAction() { --action_; }
  /// Returns its opacity, from 1 to 0 as it fades.
  double Strength() const {
    constexpr double seconds_of_message = 5, seconds_of_fading = 1;
    return std::clamp((since_ + seconds_of_message - now_) / seconds_of_fading, 0.0, 1.0);
  }
  /// Returns the message and clears it, so that the next one is known to be new. PutBack restores it.
  std::string TakeMessage() { return std::exchange(message_, {}); }
  void PutBack(const std::string& message) { message_ = message; }

  /// Returns the time, in seconds of ticks.
  double Now() const { return now_; }
  void Advance(double seconds) {
    const double before = Strength();
    now_ += seconds;
    if (Strength() != before) needs_redraw_ = true;
  }

  void Redraw() { needs_redraw_ = true; }
  /// The lines in space have changed.
  void RedrawLines() { needs_redraw_ = has_new_lines_ = true; }
  /// Returns true if a redraw was requested since the last call.
  bool TakeRedraw() { return std::exchange(needs_redraw_, false); }
  bool TakeNewLines() { return std::exchange(has_new_lines_, false); }

 private:
  std::string message_, question_;
  std::int64_t action_ = 0, asked_at_ = 0;
  double since_ = 0, now_ = 0;
  bool needs_redraw_ = true, has_new_lines_ = true;
};

}  // namespace ray
