#include "converter/number_table.h"

#include <string>
#include <string_view>

#include "converter/conversion_job.h"
#include "files/pending_file.h"
#include "model/number_digits.h"

namespace ribbon {

namespace {

void append_cell(std::string& line, auto number) {
  line += ',';
  append_digits(line, number);
}

// A text between quotation marks, where those of its own stand twice: it may hold commas.
void append_text_cell(std::string& line, std::string_view text) {
  line += ",\"";
  for (const char c : text) line.append(c == '"' ? 2 : 1, c);
  line += '"';
}

std::string line_of(int frame, const RecordingHeader& header,
                    const std::optional<FrameNumbers>& numbers) {
  const bool has_stages = !header.stages.empty();
  std::string line = std::to_string(frame);
  if (!numbers)
    return line + std::string(4 + tightness_columns.size() + (has_stages ? 1 : 0), ',') + '\n';
  append_cell(line, numbers->time_s);
  append_cell(line, numbers->worst_strain);
  append_cell(line, numbers->penetrating_edges);
  append_cell(line, numbers->recovery_iterations);
  for (const TightnessColumn& column : tightness_columns)
    if (numbers->tightness)
      append_cell(line, (*numbers->tightness).*column.value);
    else
      line += ',';
  if (has_stages) append_text_cell(line, stage_name(header, *numbers));
  return line + '\n';
}

Result<void> append_lines(PendingFile& file, const ConversionRequest& request,
                          const RecordingReader& reader, const std::vector<int>& frames,
                          ConversionReport& report) {
  if (auto appended = file.append(number_table_title(reader.header())); !appended) return appended;
  for (const int index : frames) {
    if (request.interrupted()) return interrupted_conversion();
    const auto numbers = reader.numbers(index);
    report.frames_written += numbers ? 1 : 0;
    if (auto appended = file.append(line_of(index + 1, reader.header(), numbers)); !appended)
      return appended;
  }
  if (report.frames_written == 0)
    return failure("", "none of the frames has numbers that can be read", "record it again");
  return {};
}

// Indices tell the numbers of frames that are lost, too.
void find_losses(RecordingReader& reader, const std::vector<int>& frames,
                 ConversionReport& report) {
  reader.check();
  for (const int index : frames)
    if (!reader.readable(index)) report.missing.push_back(index + 1);
  report.damage = reader.damage();
}

}  // namespace

std::string number_table_title(const RecordingHeader& header) {
  std::string line =
      "frame,time [s],worst_strain [1],penetrating_edges [1],recovery_iterations [1]";
  for (const TightnessColumn& column : tightness_columns) {
    const bool is_length = column.value == &TightnessNumbers::rope_length;
    line += std::string(",") + column.name + (is_length ? " [ribbon widths]" : " [1]");
  }
  if (!header.stages.empty()) line += ",stage";
  return line + '\n';
}

std::string number_table_line(const RecordingReader& reader, int index) {
  return line_of(index + 1, reader.header(), reader.numbers(index));
}

Result<ConversionReport> write_number_table(const ConversionRequest& request,
                                            RecordingReader& reader,
                                            const std::vector<int>& frames) {
  auto file = PendingFile::create(request.output);
  if (!file) return tl::unexpected(file.error());
  ConversionReport report;
  report.first_file = report.last_file = request.output;
  return append_lines(*file, request, reader, frames, report)
      .and_then([&] { return file->finish(request.later()); })
      .map([&] {
        report.bytes_written = file->size();
        find_losses(reader, frames, report);
        return report;
      });
}

}  // namespace ribbon
