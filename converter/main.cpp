// ribbon-convert: a recording becomes files for modelling packages.
#include <chrono>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "commandline/interrupt.h"
#include "commandline/tool.h"
#include "converter/conversion.h"
#include "converter/dry_run.h"
#include "converter/options.h"
#include "converter/output_verification.h"
#include "parallel/parallel.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

std::string pinched_text(int most) {
  if (most == 0) return "";
  return filled_in(
      ", but where it is crumpled: there front and back touch, at up to {} {} of a frame", most,
      most == 1 ? "particle" : "particles");
}

std::string left_out_text(int frames) {
  return frames == 1 ? "single frames are" : filled_in("up to {} frames in a row are", frames);
}

void print_summary(const ConversionReport& report, double seconds) {
  const bool several = report.first_file != report.last_file;
  const int frames = report.frames_written + report.frames_repeated;
  if (frames > 0) std::printf("%d %s, ", frames, frames == 1 ? "frame" : "frames");
  if (report.frames_repeated > 0)
    std::printf("%d of them the same as another, ", report.frames_repeated);
  if (report.frames_kept > 0) std::printf("%d of them kept, ", report.frames_kept);
  std::printf("%.1f MB in %.1f s: %s%s%s\n", static_cast<double>(report.bytes_written) / 1e6,
              seconds, report.first_file.c_str(), several ? " ... " : "",
              several ? report.last_file.c_str() : "");
  if (report.left_out > 0)
    std::printf(
        "%s left out between frames that are kept: straight ways between these, by which the knot "
        "is followed, may now pass through cloth; ribbon-play --verify tells whether they do\n",
        left_out_text(report.left_out).c_str());
  if (report.least_thickness_m)
    std::printf("the ribbon is at least %s thick%s\n",
                metres(*report.least_thickness_m, Rounding::down).c_str(),
                pinched_text(report.most_pinched).c_str());
}

void print_losses(const std::vector<Damage>& damages, const std::vector<int>& missing) {
  for (const Damage& damage : damages)
    std::fprintf(stderr, "ribbon-convert: damaged at byte %llu, %llu bytes skipped: %s\n",
                 static_cast<unsigned long long>(damage.byte),
                 static_cast<unsigned long long>(damage.length), damage.reason.c_str());
  if (!missing.empty())
    std::fprintf(stderr, "ribbon-convert: the recording has lost %zu of the frames: %s\n",
                 missing.size(), number_list(missing).c_str());
}

void print_refused(const ConversionReport& report) {
  if (!report.refused.empty())
    std::fprintf(stderr, "ribbon-convert: %zu of the frames cannot be made a solid: %s\n",
                 report.refused.size(), number_list(report.refused).c_str());
}

void tell(const ConversionReport& report, double seconds, bool quiet) {
  if (!quiet) print_summary(report, seconds);
  for (const std::string& remark : report.remarks)
    std::fprintf(stderr, "ribbon-convert: %s\n", remark.c_str());
  print_losses(report.damage, report.missing);
  print_refused(report);
}

ExitCode exit_code(const ConversionReport& report) {
  const bool whole = report.missing.empty() && report.refused.empty() && report.damage.empty();
  return whole ? ExitCode::done : ExitCode::answer_is_no;
}

Result<ConversionReport> convert_and_tell(const CommandLine& line) {
  const auto start = std::chrono::steady_clock::now();
  auto report = convert(line.request);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  if (report) tell(*report, elapsed.count(), line.quiet);
  return report;
}

// Good news go where the summary goes.
Result<VerificationReport> verify_and_tell(const CommandLine& line) {
  auto report = verify_output(line.request, line.tolerance_m);
  if (!report) return report;
  const std::string text = verification_text(*report);
  const bool good = report->deviations.good();
  if (!good) std::fprintf(stderr, "ribbon-convert: %s\n", text.c_str());
  if (good && !line.quiet) std::printf("%s\n", text.c_str());
  return report;
}

// No conversion has told what the recording has lost.
Result<ExitCode> verify_alone(const CommandLine& line) {
  return verify_and_tell(line).map([](const VerificationReport& report) {
    const std::set<int>& missing = report.deviations.missing;
    print_losses(report.damage, {missing.begin(), missing.end()});
    const bool whole = missing.empty() && report.damage.empty();
    return whole && report.deviations.good() ? ExitCode::done : ExitCode::answer_is_no;
  });
}

// The recording may have grown in between: what is read back is what was written.
Result<ExitCode> convert_and_verify(CommandLine line) {
  const auto report = convert_and_tell(line);
  if (!report) return tl::unexpected(report.error());
  line.request.frame_count = report->frame_count;
  return verify_and_tell(line).map([&](const VerificationReport& verified) {
    return verified.deviations.good() ? exit_code(*report) : ExitCode::answer_is_no;
  });
}

Result<ExitCode> plan(const ConversionRequest& request) {
  return plan_conversion(request).map([](const ConversionPlan& plan) {
    std::printf("%s\n", plan_text(plan).c_str());
    return ExitCode::done;
  });
}

Result<ExitCode> do_job(const CommandLine& line) {
  if (line.dry_run) return plan(line.request);
  if (line.verify_only) return verify_alone(line);
  if (!line.verify) return convert_and_tell(line).map(exit_code);
  return check_verifiable(line.request).and_then([&] { return convert_and_verify(line); });
}

Result<ExitCode> run(int argc, const char* const* argv) {
  auto line = parse_command_line(argc, argv);
  if (!line) return tl::unexpected(line.error());
  if (!*line) return ExitCode::done;
  set_thread_limit((*line)->threads);
  const Interrupt interrupt;
  (*line)->request.interrupted = [&] { return interrupt.requested(); };
  return do_job(**line);
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("ribbon-convert", [&] { return ribbon::run(argc, argv); });
}
