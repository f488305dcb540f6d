#include "player/made_of.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "player/render/ray_scene.h"
#include "recording/coding/checksum.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 20;

// Whatever is not named here counts: an option that is added and forgotten here makes pictures anew
// that need not be, never the other way round.
constexpr std::array changes_no_pixel{
    "RECORDING",  "--output", "--frames", "--reverse", "--ping-pong", "--fps",
    "--hold",     "--shard",  "--resume", "--force",   "--isa",       "--threads",
    "--progress", "--quiet",  "--sheet",  "--plot",    "--info",      "--json"};
// But where the camera turns, or colours are chosen by what there is, a picture depends on the
// others.
constexpr std::array changes_the_film{"--frames", "--reverse", "--ping-pong", "--fps", "--hold"};

template <class Names>
bool is_among(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "1656992 bytes, checksum 8a2f33b1", that of the checksums of its pieces: a long file need not fit
// into memory.
Result<std::string> fingerprint(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string piece(piece_bytes, '\0');
  std::string checksums;
  std::uint64_t bytes = 0;
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto got = static_cast<std::size_t>(file.gcount());
    checksums += hexadecimal(checksum(std::string_view(piece).substr(0, got)));
    bytes += got;
  }
  if (!file.eof()) return failure(path.string(), "cannot be read", "check its permissions");
  return filled_in("{} bytes, checksum {}", bytes, hexadecimal(checksum(checksums)));
}

// Line ends would end the line that it stands in.
std::string in_one_line(const std::string& value) {
  std::string line;
  for (const char letter : value) {
    if (letter == '\n')
      line += "\\n";
    else if (letter == '\\')
      line += "\\\\";
    else
      line += letter;
  }
  return line;
}

Result<std::string> value_text(const std::string& value) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(value, code)) return in_one_line(value);
  return fingerprint(value).map(
      [&](const std::string& file) { return in_one_line(value) + " (" + file + ")"; });
}

Result<std::string> settings_text(const Options& options, std::size_t shot) {
  const bool depends_on_others = options.turns != 0 || options.appearance.color_by;
  std::string text;
  for (const GivenArgument& argument : options.given) {
    const bool counts = !is_among(changes_no_pixel, argument.name) ||
                        (depends_on_others && is_among(changes_the_film, argument.name));
    if (!counts) continue;
    text += "; " + argument.name;
    for (std::size_t i = 0; i < argument.values.size(); ++i) {
      if (argument.name == "--view" && i != shot) continue;
      auto value = value_text(argument.values[i]);
      if (!value) return value;
      text += " " + *value;
    }
  }
  return text;
}

}  // namespace

Result<std::vector<MadeOf>> made_of(const RecordingReader& reader, const Options& options,
                                    std::size_t shots) {
  const auto recording = fingerprint(options.recording);
  if (!recording) return tl::unexpected(recording.error());
  const std::string common = "recording " + hexadecimal(reader.recording_id()) + " (" + *recording +
                             "); ribbon-play " RIBBON_VERSION "; " + ray_tracer_name();
  std::vector<MadeOf> made;
  for (std::size_t shot = 0; shot < shots; ++shot) {
    const auto settings = settings_text(options, shot);
    if (!settings) return tl::unexpected(settings.error());
    made.push_back(common + *settings);
  }
  return made;
}

}  // namespace ribbon
