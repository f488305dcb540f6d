// Options that tell which frame is shown when.
#pragma once

#include <string>

#include "commandline/arguments.h"
#include "player/output/play_order.h"
#include "result/result.h"

namespace ribbon {

// As users write it.
struct OrderTexts {
  bool reverse = false;
  bool ping_pong = false;
  double frames_per_second = 0;  // 0: as recorded
  bool interpolates = false;
  std::string hold;  // as parse_hold reads it; empty: none
};

// They need pictures, and a recording that does not grow.
void add_order_options(Arguments& arguments, OrderTexts& texts, Argument pictures, Argument follow);

// Fails when a text cannot be understood.
Result<PlayOrder> read_order(const OrderTexts& texts);

}  // namespace ribbon
