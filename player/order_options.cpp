#include "player/order_options.h"

namespace ribbon {

void add_order_options(Arguments& arguments, OrderTexts& texts, Argument pictures,
                       Argument follow) {
  arguments.flag("--reverse", texts.reverse, "play backwards").needs(pictures).excludes(follow);
  arguments.flag("--ping-pong", texts.ping_pong, "play there and back, to be repeated")
      .needs(pictures)
      .excludes(follow);
  const auto rate =
      arguments
          .add("--fps", texts.frames_per_second, {1e-3, 1e4}, "RATE",
               "so many pictures a second, each of the nearest recorded frame; also of a video "
               "(default: as recorded)")
          .needs(pictures)
          .excludes(follow);
  const auto interpolate = arguments
                               .flag("--interpolate", texts.interpolates,
                                     "of --fps: show what lies between recorded frames, which may "
                                     "intersect, instead of the nearest")
                               .needs(rate);
  arguments
      .add("--hold", texts.hold, "N",
           "show each frame in N pictures, or as 4s for so many seconds: with --turns a turntable "
           "of one frame")
      .needs(pictures)
      .excludes(interpolate)
      .excludes(follow);
}

Result<PlayOrder> read_order(const OrderTexts& texts) {
  PlayOrder order{
      .reverse = texts.reverse, .ping_pong = texts.ping_pong, .interpolates = texts.interpolates};
  if (texts.frames_per_second > 0) order.frames_per_second = texts.frames_per_second;
  if (texts.hold.empty()) return order;
  return parse_hold(texts.hold).map([&](const Hold& hold) {
    order.hold = hold;
    return order;
  });
}

}  // namespace ribbon
