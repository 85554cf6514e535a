#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "source/draw/FrameState.h"
#include "source/view/compare/ReferenceImage.h"
#include "source/view/live/RenderJob.h"

namespace ray {

/// The images that a viewer renders: that of key S, row by row; and the live image, which starts over with every move.
/// Either may be compared with a reference.
class TracedImages {
 public:
  /// reference     the reference itself
  /// difference    |x - r|, channel by channel
  /// false_colors  the largest difference of a channel as displayed, from black (0) to white (the largest of all)
  /// flip          how different both look, from black (0) to white (1); R2::Flip
  enum class Comparing { no, reference, difference, false_colors, flip };

  // The image of key S.
  /// `continues`: where the last one of the same scene and settings was stopped; CanContinue.
  void StartTrace(std::shared_ptr<const LoadedScene> scene, const RenderSettings& settings, bool continues = false);
  /// Returns true if the image was stopped with samples.
  bool CanContinue() const { return Trace() && Trace()->Canceled(); }
  /// Stops it, and returns true if it was being rendered. Its pixels stay.
  bool StopTrace();
  const RenderJob* Trace() const { return trace_.Current(); }
  bool IsTracing() const { return Trace() && !Trace()->HasEnded(); }
  /// Returns true if it is being traced, or has ended without having been taken.
  bool IsUnsaved() const { return Trace() && !has_reported_end_; }
  /// The trace, once, when it has ended since the last call.
  const RenderJob* TakeEnded();
  void ForgetTrace() { trace_.Abandon(); }

  // The live image: shown while the view rests and, if tracing is fast enough, while it moves.
  /// `mode`: in place of the settings' mode; std::nullopt for the latter.
  void ShowLive(std::optional<RenderMode> mode);
  void HideLive();
  /// Until the view or the scene changes, the image of key S is shown instead.
  void Suspend();
  bool IsLive() const { return is_live_; }
  std::optional<RenderMode> LiveMode() const { return mode_; }
  /// Makes the live image start over with the next Update.
  void Touch();
  /// The view has moved.
  void TouchView();
  /// Returns the live image to show, or the one before it while it has no pixels yet; null to show the preview.
  const RenderJob* ShownLive() const;
  std::uint64_t ShownLiveNumber() const { return ShownLive() == Live() ? live_number_ : last_number_; }
  /// The opacity of ShownLive over the preview, in [0, 1]: it fades in.
  double Opacity() const;
  /// Starts the live image if it is due: at once where tracing is fast, else once the view rests. `budget_of_rest`:
  /// the settings have no budget of their own, so that samples_at_rest are taken where they improve the image.
  void Update(const std::shared_ptr<const LoadedScene>& scene, const RenderSettings& settings,
              bool budget_of_rest = false);
  static constexpr int samples_at_rest = 64;
  /// Returns true if the live image was stopped, and has more to come.
  bool IsPaused() const { return is_live_ && !is_due_ && Live() && Live()->HasEnded() && Live()->Canceled(); }
  /// Continues it where it was stopped.
  void ResumeLive();

  // Depths of the live image, so that lines in space are hidden behind its surfaces.
  /// Starts to compute them for the image shown, unless they exist or the view moves.
  void TraceDepths();
  /// Their job once it is complete; null before, and for another view.
  const RenderJob* Depths() const;
  std::uint64_t DepthsNumber() const { return depths_number_; }

  /// Stops it, and returns true if it was being rendered. Its pixels stay until it starts over.
  bool StopLive();
  /// The live image, once, when it has ended by itself since the last call.
  const RenderJob* TakeEndedLive();
  const RenderJob* Live() const { return live_.Current(); }
  /// The live image if it is shown, else that of key S; null if there is none. With its number.
  const RenderJob* Job() const { return is_live_ && Live() ? Live() : Trace(); }
  std::uint64_t JobNumber() const { return Job() == Trace() ? trace_number_ : live_number_; }
  bool IsBusy() const;
  /// Every job ever started has a number of its own.
  std::uint64_t TraceNumber() const { return trace_number_; }

  // Comparing.
  void SetReference(ReferenceImage reference);
  /// Sets the encoding of files of bytes: a reference of bytes is compared with what such a file would hold.
  void SetEncoding(const ByteEncoding& encoding);
  /// The reference as light; null without one.
  const std::shared_ptr<const R2::Image>& Reference() const { return reference_light_; }
  /// Returns the image to be compared: the live one if it is shown, else the trace, so far; null if there is none.
  std::shared_ptr<const R2::Image> Current() const;
  void Compare(Comparing how) { comparing_ = how; }
  Comparing HowCompared() const { return comparing_; }
  /// Describes the RMSE against the reference, or why they cannot be compared.
  std::string Comparison() const;
  /// The image shown instead of the current image while comparing; null when none is.
  std::shared_ptr<const R2::Image> Compared() const;
  /// Returns the scale of false colors, or a text that the image equals the reference; empty otherwise.
  std::string ScaleOfComparison() const;
  /// Returns true if Compared has colors that stand for numbers.
  bool ShowsFalseColors() const { return comparing_ == Comparing::false_colors || comparing_ == Comparing::flip; }
  /// Returns true if Compared is a difference of values that are already encoded.
  bool ShowsEncodedDifference() const { return comparing_ == Comparing::difference && !reference_.IsLight(); }

 private:
  std::string EncodedComparison(const R2::Image& current) const;
  /// Returns false colors of the current images, computed once per change.
  struct FalseColors {
    std::uint64_t number = 0;  // of the job, and how far it was
    int samples = -1, rows = -1, places = -1;
    bool has_ended = false;
    Comparing how = Comparing::no;
    std::shared_ptr<const R2::Image> reference, image;  // the latter null if they cannot be compared
    double largest = 0, mean = 0;
  };
  const FalseColors& InFalseColors() const;

  using Clock = std::chrono::steady_clock;

  /// Returns true if the view moved a moment ago.
  bool Moves() const;
  /// Returns true if a moving view is traced, since enough of its pixels fit into one frame of smooth motion.
  bool TracesInMotion(const RenderSettings& settings) const;
  void StartLive(const std::shared_ptr<const LoadedScene>& scene, const RenderSettings& settings, int first_places,
                 std::optional<RenderJob::Stopped> before = {});

  JobQueue trace_, live_, depths_;
  bool has_reported_end_ = true, has_reported_live_end_ = true;
  bool is_wanted_ = false;  // the live image, once something changes
  bool is_live_ = false, is_due_ = false, moves_ = false;
  Clock::time_point moved_at_{}, shown_since_{};
  bool was_shown_ = false;
  std::optional<RenderMode> mode_;
  std::uint64_t jobs_ = 0, trace_number_ = 0, live_number_ = 0, last_number_ = 0;
  std::uint64_t depths_number_ = 0, depths_of_ = 0;  // the latter the number of the live image that has these
  double pixels_per_second_ = 0;                     // of the live image's last pass
  ReferenceImage reference_;
  std::shared_ptr<const R2::Image> reference_light_;
  ByteEncoding encoding_;
  Comparing comparing_ = Comparing::no;
  mutable FalseColors false_colors_;
};

}  // namespace ray
