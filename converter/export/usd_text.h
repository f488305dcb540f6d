// The words of USD's text form.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace ribbon {

// A name that a prim may have: letters, digits and _, no digit first. What else there is becomes _,
// a character of UTF-8 one of them.
std::string usd_identifier(std::string_view name);

// In quotation marks.
std::string usd_string(std::string_view text);

// The address of a file beside the one that this stands in. It cannot hold "@@@".
std::string usd_asset(std::string_view file_name);

// "[1, 2, 3]"
std::string usd_array(const Eigen::Ref<const Eigen::VectorXi>& numbers);

// "[(0, 1.5), (2, 3)]" of the columns, at most 3 rows, in shortest decimals that read back the
// same; on all cores.
void append_usd_array_of_tuples(std::string& text,
                                const Eigen::Ref<const Eigen::MatrixXf>& columns);
std::string usd_array_of_tuples(const Eigen::Ref<const Eigen::MatrixXf>& columns);

}  // namespace ribbon
