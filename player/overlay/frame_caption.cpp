#include "player/overlay/frame_caption.h"

#include <algorithm>
#include <cmath>

#include "inspection/tightness_progress_text.h"
#include "player/picture/legend.h"
#include "player/picture/page_colors.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

std::string where_line(const Overlays& overlays, double frame, double time_s) {
  std::string text;
  if (overlays.frame) text = "frame " + short_number(frame, 9);
  if (overlays.time) text += (text.empty() ? "" : " · ") + filled_in("{:.2f} s", time_s);
  return text;
}

std::string strain_line(const FrameNumbers& numbers) {
  std::string text = filled_in("strain {:.1f} %", 100 * numbers.worst_strain);
  if (numbers.penetrating_edges == 0) return text;
  return text + filled_in(" · {} {}", numbers.penetrating_edges,
                          numbers.penetrating_edges == 1 ? "penetration" : "penetrations");
}

std::string tightness_line(const TightnessNumbers& tightness) {
  return tightness_progress_text(tightness.progress) +
         filled_in(" · pull {:.1f} % · in contact {:.1f} %", 100 * tightness.pull,
                   100 * tightness.contact);
}

}  // namespace

std::vector<std::string> frame_caption(const Overlays& overlays, double frame,
                                       const FrameNumbers& numbers, const std::string& stage) {
  std::vector<std::string> lines;
  if (overlays.frame || overlays.time)
    lines.push_back(where_line(overlays, frame, numbers.time_s) +
                    (stage.empty() ? "" : " · " + stage));
  if (overlays.has_caption() && frame != std::floor(frame)) lines.emplace_back("interpolated");
  if (!overlays.numbers) return lines;
  lines.push_back(strain_line(numbers));
  if (numbers.tightness) lines.push_back(tightness_line(*numbers.tightness));
  return lines;
}

void draw_caption(const std::vector<std::string>& lines, const CaptionPainter& painter,
                  Picture& picture) {
  if (lines.empty()) return;
  const int text = picture_text_height(picture.size);
  const int line_height = (3 * text) / 2;
  const int padding = (3 * text) / 4;
  const int room = picture.size.width - 2 * (text + padding);
  std::vector<std::string> fitted;
  int width = 0;
  for (const std::string& line : lines) {
    fitted.push_back(painter.fitted(line, text, room));
    width = std::max(width, painter.width(fitted.back(), text));
  }
  const auto count = static_cast<int>(lines.size());
  fill({text, text, text + width + 2 * padding,
        text + count * line_height - (line_height - text) + 2 * padding},
       page_paper, 0.75F, picture);
  int baseline = text + padding + (7 * text) / 8;
  for (const std::string& line : fitted) {
    painter.draw(line, text + padding, baseline, text, page_ink, picture);
    baseline += line_height;
  }
}

}  // namespace ribbon
