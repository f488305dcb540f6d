// Makes the text of libribbon/recording/entropy_tables.cpp's tables from recordings:
//   train_entropy_tables hourglass.rbn cylinder.rbn small-object.rbn
// Frames are encoded without tables at three bounds; what each kind of run then holds gives its
// table. Prints them in hexadecimal digits, a line for each kind.
#include <zdict.h>

#include <array>
#include <cstdio>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/recorded_motion.h"
#include "recording/position_encoder.h"
#include "recording/references.h"

namespace ribbon {

namespace {

struct Options {
  std::vector<std::string> recordings;
};

// Runs of one kind, one behind the other.
struct Samples {
  std::string bytes;
  std::vector<std::size_t> sizes;
};
using SamplesByKind = std::array<Samples, symbol_kinds>;

void note(const SymbolRuns& runs, SamplesByKind& samples) {
  constexpr std::size_t enough = 3'000'000;  // of a kind; zstd weighs all of them
  for (std::size_t kind = 0; kind < runs.size(); ++kind) {
    if (runs[kind].size() < 16 || samples[kind].bytes.size() > enough) continue;
    samples[kind].bytes += runs[kind];
    samples[kind].sizes.push_back(runs[kind].size());
  }
}

void encode(const RecordedMotion& motion, double relative_bound, SamplesByKind& samples) {
  RecordingHeader header = motion.header;
  header.max_position_error_m = relative_bound * header.ribbon_length_m;
  header.lattice_step_m = motion.lattice_step_m(header.max_position_error_m);
  header.entropy_tables.clear();
  PositionEncoder encoder(codec_parameters(header), header.max_position_error_m);
  std::vector<LatticeFrame> frames;
  frames.reserve(motion.frames.size());
  for (const Eigen::Matrix3Xf& positions : motion.frames) {
    std::vector<const LatticeFrame*> references;
    for (const std::uint32_t reference : live_references(static_cast<std::uint32_t>(frames.size())))
      references.push_back(&frames[reference]);
    auto encoded = encoder.encode(positions.cast<double>(), references);
    if (!encoded) return;
    note(encoder.symbol_runs(), samples);
    frames.push_back(std::move(encoded->frame));
  }
}

// A zstd dictionary without content of its own: only its tables matter.
std::string table_of(const Samples& samples) {
  const std::string content(8, '\0');
  std::string table(4096, '\0');
  const ZDICT_params_t parameters{.compressionLevel = 1, .notificationLevel = 0, .dictID = 1};
  const std::size_t size = ZDICT_finalizeDictionary(
      table.data(), table.size(), content.data(), content.size(), samples.bytes.data(),
      samples.sizes.data(), static_cast<unsigned>(samples.sizes.size()), parameters);
  if (ZDICT_isError(size) != 0) return "";
  table.resize(ZDICT_getDictHeaderSize(table.data(), size));
  return table + content;
}

Result<ExitCode> train(const Options& options) {
  SamplesByKind samples;
  for (const std::string& recording : options.recordings) {
    const auto motion = read_motion(recording);
    if (!motion) return tl::unexpected(motion.error());
    for (const double bound : {3e-6, 1e-5, 3e-5}) encode(*motion, bound, samples);
  }
  for (const Samples& kind : samples) {
    for (const char byte : table_of(kind))
      std::printf("%02x", static_cast<unsigned>(static_cast<unsigned char>(byte)));
    std::printf("\n");
  }
  return ExitCode::done;
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::benchmark_main<ribbon::Options>(
      "train_entropy_tables", argc, argv,
      [](CLI::App& app, ribbon::Options& options) {
        app.add_option("RECORDING", options.recordings, "recordings to learn from (.rbn)")
            ->required()
            ->type_name("FILE");
      },
      ribbon::train);
}
