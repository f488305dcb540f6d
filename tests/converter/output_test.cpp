#include <gtest/gtest.h>

#include "converter/output_format.h"
#include "converter/output_names.h"
#include "result/refusal.h"

namespace ribbon::output_test {

TEST(OutputFormat, the_extension_tells_it_in_any_case) {
  EXPECT_EQ(output_format("out/knot.{frame:04}.obj").value(), OutputFormat::obj);
  EXPECT_EQ(output_format("knot.FBX").value(), OutputFormat::fbx);
  EXPECT_EQ(output_format("a.b/knot.pc2").value(), OutputFormat::pc2);
}

TEST(OutputFormat, an_unknown_one_is_answered_with_what_there_is) {
  for (const char* output : {"knot.doc", "knot", "out.obj/knot"})
    for (const char* extension : {".obj", ".fbx", ".pc2"})
      EXPECT_THAT(refusal_of(output_format(output)), HasSubstr(extension)) << output;
}

TEST(OutputFormat, a_broken_one_is_refused_with_the_reason) {
  EXPECT_THAT(refusal_of(output_format("knot.3mf")), HasSubstr("fourth corner"));
  EXPECT_THAT(refusal_of(output_format("knot.GLTF")), HasSubstr("quads"));
}

TEST(OutputNames, the_material_library_is_named_after_the_sequence) {
  EXPECT_EQ(material_library_name("out/knot.{frame:04}.obj"), "knot.mtl");
  EXPECT_EQ(material_library_name("{frame}_first knot.obj"), "first knot.mtl");
  EXPECT_EQ(material_library_name("out/{frame:04}.obj"), "ribbon.mtl");
  EXPECT_EQ(material_library_name("{frame}/knot.obj"), "knot.mtl");
  EXPECT_EQ(material_library_name("knot.pc2"), "knot.mtl");
}

}  // namespace ribbon::output_test
