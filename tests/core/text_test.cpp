#include <gtest/gtest.h>

#include "beadswim/core/nearest_name.hpp"
#include "beadswim/core/sha256.hpp"
#include "beadswim/core/version.hpp"

namespace beadswim {
namespace {

TEST(NearestName, FindsTheLikelyMeaning) {
  const std::vector<std::string> names{"radius", "density", "damping", "stiffness"};
  EXPECT_EQ(nearest_name("raduis", names), "radius");   // neighbours swapped
  EXPECT_EQ(nearest_name("dampng", names), "damping");  // a letter missing
  EXPECT_EQ(nearest_name("stifness", names), "stiffness");
  EXPECT_EQ(nearest_name("viscosty", {"schema", "kinematic_viscosity"}), "kinematic_viscosity");  // of a part
  EXPECT_EQ(nearest_name("LBM", {"rpy", "lbm"}), "lbm");
  EXPECT_EQ(nearest_name("log", {"linear", "log-y"}), "log-y");
}

TEST(NearestName, IsEmptyWhereNoneIsNear) {
  EXPECT_EQ(nearest_name("x", {}), "");
  EXPECT_EQ(nearest_name("x", {"y"}), "");  // nothing in common
  EXPECT_EQ(nearest_name("foo", {"radius", "box"}), "");
  EXPECT_EQ(nearest_name("dt", {"tolerance", "time-limit"}), "");
  EXPECT_EQ(nearest_name("", {"radius"}), "");
  EXPECT_EQ(nearest_name(std::string(101, 'r'), {std::string(100, 'r')}),
            "");  // no name has a hundred letters
  EXPECT_EQ(format_suggestion("foo", {"radius"}), ".");
  EXPECT_EQ(format_suggestion("raduis", {"radius"}), "; did you mean \"radius\"?");
}

// NIST's examples, FIPS 180-2, appendix B.
TEST(Sha256, GivesThePublishedDigests) {
  const auto digest = [](const std::string& text) {
    Sha256 hash;
    hash.update(std::as_bytes(std::span(text)));
    return hash.hexadecimal();
  };
  EXPECT_EQ(digest("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Version, IsThreeNumbers) {
  int major = -1, minor = -1, patch = -1;
  EXPECT_EQ(std::sscanf(version().c_str(), "%d.%d.%d", &major, &minor, &patch), 3);
  EXPECT_FALSE(revision().empty());
}

}  // namespace
}  // namespace beadswim
