#include <gtest/gtest.h>

#include "converter/motion_format.h"
#include "converter/output_format.h"
#include "converter/output_names.h"
#include "result/refusal.h"

namespace ribbon::output_test {

TEST(OutputFormat, the_extension_tells_it_in_any_case) {
  EXPECT_EQ(output_format("out/knot.{frame:04}.obj").value(), OutputFormat::obj);
  EXPECT_EQ(output_format("knot.FBX").value(), OutputFormat::fbx);
  EXPECT_EQ(output_format("a.b/knot.pc2").value(), OutputFormat::whole_motion);
}

TEST(OutputFormat, every_format_of_a_whole_motion_is_known_and_takes_no_frame_number) {
  for (const MotionFormat& format : motion_formats()) {
    const std::string extension(format.extension);
    if (extension == ".fbx") continue;  // with a number it is a sequence
    EXPECT_EQ(output_format("knot" + extension).value(), OutputFormat::whole_motion);
    EXPECT_EQ(motion_format("out.obj/knot" + extension)->new_writer, format.new_writer);
    EXPECT_THAT(refusal_of(output_format("knot.{frame}" + extension)),
                HasSubstr("leave {frame} out"));
  }
  EXPECT_EQ(output_format("knot.csv").value(), OutputFormat::numbers);
  EXPECT_THAT(refusal_of(output_format("{frame}.csv")), HasSubstr("leave {frame} out"));
}

TEST(OutputFormat, an_unknown_one_is_answered_with_what_there_is) {
  for (const char* output : {"knot.doc", "knot", "out.obj/knot"})
    for (const char* extension : {".obj", ".fbx", ".pc2", ".mdd", ".csv"})
      EXPECT_THAT(refusal_of(output_format(output)), HasSubstr(extension)) << output;
}

TEST(OutputFormat, a_broken_one_is_refused_with_the_reason) {
  EXPECT_THAT(refusal_of(output_format("knot.3mf")), HasSubstr("fourth corner"));
  EXPECT_THAT(refusal_of(output_format("knot.GLTF")), HasSubstr(".glb"));
}

TEST(OutputNames, the_material_library_is_named_after_the_sequence) {
  EXPECT_EQ(material_library_name("out/knot.{frame:04}.obj"), "knot.mtl");
  EXPECT_EQ(material_library_name("{frame}_first knot.obj"), "first knot.mtl");
  EXPECT_EQ(material_library_name("out/{frame:04}.obj"), "ribbon.mtl");
  EXPECT_EQ(material_library_name("{frame}/knot.obj"), "knot.mtl");
  EXPECT_EQ(material_library_name("knot.pc2"), "knot.mtl");
}

}  // namespace ribbon::output_test
