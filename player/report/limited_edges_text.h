// Which edges of a ribbon are limited, as people and programs read it.
#pragma once

#include <string>
#include <vector>

#include "geometry/limited_edges.h"

namespace ribbon {

// Some of "along", "across", "diagonal".
inline std::vector<std::string> words_for(const LimitedEdges& edges) {
  std::vector<std::string> words;
  if (edges.along) words.emplace_back("along");
  if (edges.across) words.emplace_back("across");
  if (edges.diagonals) words.emplace_back("diagonal");
  return words;
}

// "edges along, across and diagonal"; "no edges".
inline std::string limited_edges_text(const LimitedEdges& edges) {
  const std::vector<std::string> words = words_for(edges);
  if (words.empty()) return "no edges";
  std::string text = "edges " + words.front();
  for (std::size_t k = 1; k < words.size(); ++k)
    text += (k + 1 < words.size() ? ", " : " and ") + words[k];
  return text;
}

}  // namespace ribbon
