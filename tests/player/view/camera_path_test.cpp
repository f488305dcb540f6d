#include "player/view/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "result/refusal.h"

namespace ribbon::camera_path_test {

CameraPath path_of(const std::string& table) {
  return CameraPath::parse(table, "keys.csv", three_quarter_view).value();
}

TEST(CameraPath, passes_its_keyframes_and_stands_still_outside_them) {
  const CameraPath path = path_of("time, azimuth ,lens\r\n1,10,50\r\n\r\n2,40,50\r\n4,0,100\r\n");
  for (const auto& [time_s, azimuth] :
       {std::pair{0.0, 10.0F}, {1.0, 10.0F}, {2.0, 40.0F}, {4.0, 0.0F}, {9.0, 0.0F}})
    EXPECT_FLOAT_EQ(path.at(time_s).view.azimuth_deg, azimuth) << time_s;
  EXPECT_EQ(path.at(1.5).view.elevation_deg, three_quarter_view.elevation_deg);
  EXPECT_FALSE(path.at(1.5).target);
}

TEST(CameraPath, is_read_as_spreadsheets_write_it) {
  for (const std::string table :
       {"\xEF\xBB\xBFtime,azimuth\r\n1,10.5\r\n", "\"time\",\"azimuth\"\n\"1\",\"10.5\"\n",
        "time;azimuth\n1;10,5\n", "time\tazimuth\n1,0\t10,5\n"})
    EXPECT_FLOAT_EQ(path_of(table).at(1).view.azimuth_deg, 10.5F) << table;
}

TEST(CameraPath, has_no_jolts) {
  const CameraPath path = path_of("time,azimuth\n0,0\n1,30\n3,-20\n4,0\n");
  const auto speed = [&](double t) {
    return (path.at(t + 1e-3).view.azimuth_deg - path.at(t - 1e-3).view.azimuth_deg) / 2e-3;
  };
  for (const double key : {0.0, 1.0, 3.0, 4.0})
    EXPECT_NEAR(speed(key - 2e-3), speed(key + 2e-3), 1.5) << key;
  EXPECT_NEAR(speed(0), 0, 0.5);
}

TEST(CameraPath, a_mistake_is_told_with_its_line) {
  const auto refusal = [](const std::string& table) {
    return refusal_of(CameraPath::parse(table, "keys.csv", three_quarter_view));
  };
  for (const char* empty : {"", "\n", " \r\n0,3\n"})
    EXPECT_THAT(refusal(empty), StartsWith("keys.csv:1: does not name the columns")) << empty;
  EXPECT_THAT(refusal("azimuth\n3\n"), HasSubstr("no column 'time'"));
  EXPECT_THAT(refusal("time,roll\n0,3\n"), HasSubstr("no column 'roll'"));
  EXPECT_THAT(refusal("time,x,y\n0,3,3\n"), HasSubstr("x, y and z"));
  EXPECT_THAT(refusal("time,lens,lens\n0,3,3\n"), HasSubstr("twice"));
  EXPECT_THAT(refusal("time,azimuth\n"), HasSubstr("no keyframe"));
  EXPECT_THAT(refusal("time,azimuth\n0,0\n1\n"), StartsWith("keys.csv:3: has 1 fields"));
  EXPECT_THAT(refusal("time,azimuth\n0,0\n1,x\n"), StartsWith("keys.csv:3: 'x' is not"));
  EXPECT_THAT(refusal("time,elevation\n0,120\n"), StartsWith("keys.csv:2: '120' is not"));
  EXPECT_THAT(refusal("time,azimuth\n1,0\n1,3\n"), HasSubstr("not later"));
  EXPECT_THAT(refusal_of(CameraPath::read("/no/such.csv", three_quarter_view)),
              StartsWith("/no/such.csv: "));
}

}  // namespace ribbon::camera_path_test
