// Makes the text of libribbon/recording/codec/entropy_tables.cpp's tables from recordings:
//   train_entropy_tables hourglass.rbn cylinder.rbn small-object.rbn
// Frames are encoded without tables at three bounds; what each kind of run then holds gives its
// table. Prints them in hexadecimal digits, a line for each kind.
#define ZSTD_STATIC_LINKING_ONLY  // for the layout of frames
#include <zdict.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/benchmark_main.h"
#include "benchmarks/codec/recorded_motion.h"
#include "recording/codec/position_encoder.h"
#include "recording/writer/references.h"

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
  header.quantisation_step_m = motion.quantisation_step_m(header.max_position_error_m);
  header.entropy_tables.clear();
  PositionEncoder encoder(codec_parameters(header), header.max_position_error_m);
  std::vector<QuantisedFrame> frames;
  frames.reserve(motion.frames.size());
  for (const Eigen::Matrix3Xf& positions : motion.frames) {
    const auto references = frames_of(live_references(static_cast<std::uint32_t>(frames.size())),
                                      [&](std::uint32_t k) { return &frames[k]; });
    auto encoded = encoder.encode(positions.cast<double>(), references);
    if (!encoded) return;
    note(encoder.symbol_runs(), samples);
    frames.push_back(std::move(encoded->frame));
  }
}

// What zstd writes of the tree by which it codes the literals of a compressed block, and behind it.
struct Tree {
  std::string_view description;
  std::string_view rest;
};
Tree tree_at(std::string_view bytes) {
  const auto head = static_cast<unsigned char>(bytes.front());
  const std::size_t size = 1 + (head < 128 ? head : (head - 127U + 1) / 2);
  return {bytes.substr(0, size), bytes.substr(size)};
}

// Samples thinned out to one block of zstd, behind them every symbol once, so that the tree of the
// block has a place for it, and the last of all bytes: zstd takes no dictionary without a place for
// it.
std::string block_of(const Samples& samples, std::span<const unsigned char> symbols) {
  constexpr std::size_t block_size = 120'000;
  std::string block = samples.bytes;
  std::shuffle(block.begin(), block.end(), std::mt19937(1));
  block.resize(std::min(block.size(), block_size));
  block.append(symbols.begin(), symbols.end());
  block += '\xFF';
  return block;
}

// The tree for the literals of a block. ZDICT gives all 256 symbols a place, which those that are
// never used do not need and the others then lack.
std::string tree_of(const std::string& block) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                     &ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, ZSTD_minCLevel());
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_literalCompressionMode, ZSTD_ps_enable);
  std::string frame(ZSTD_compressBound(block.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context.get(), frame.data(), frame.size(), block.data(), block.size());
  if (ZSTD_isError(size) != 0) return "";
  constexpr std::size_t block_head_size = 3;
  // Behind the frame's head stands that of the block, then that of the literals: their kind (2 says
  // that a tree follows) and in the next two bits how long it is itself.
  const std::size_t literals = ZSTD_frameHeaderSize(frame.data(), size) + block_head_size;
  const auto head = static_cast<unsigned char>(frame[literals]);
  if ((head & 3) != 2) return "";
  constexpr std::array<std::size_t, 4> head_sizes = {3, 3, 4, 5};
  return std::string(
      tree_at(std::string_view(frame).substr(literals + head_sizes[head >> 2 & 3])).description);
}

// A zstd dictionary without content of its own: only its tables matter.
std::string table_of(const Samples& samples, std::span<const unsigned char> symbols) {
  const std::string content(8, '\0');
  std::string table(4096, '\0');
  const ZDICT_params_t parameters{.compressionLevel = 1, .notificationLevel = 0, .dictID = 1};
  const std::size_t size = ZDICT_finalizeDictionary(
      table.data(), table.size(), content.data(), content.size(), samples.bytes.data(),
      samples.sizes.data(), static_cast<unsigned>(samples.sizes.size()), parameters);
  if (ZDICT_isError(size) != 0) return "";
  table.resize(ZDICT_getDictHeaderSize(table.data(), size));
  constexpr std::size_t head_size = 8;  // magic and number
  const std::string tree = tree_of(block_of(samples, symbols));
  if (tree.empty()) return "";
  return table.substr(0, head_size) + tree +
         std::string(tree_at(std::string_view(table).substr(head_size)).rest) + content;
}

Result<Findings> train(const Options& options) {
  Findings tables;
  SamplesByKind samples;
  for (const std::string& recording : options.recordings) {
    const auto motion = read_motion(recording);
    if (!motion) return tl::unexpected(motion.error());
    for (const double bound : {3e-6, 1e-5, 3e-5}) encode(*motion, bound, samples);
  }
  for (std::size_t kind = 0; kind < symbol_kinds; ++kind) {
    const std::string table = table_of(samples[kind], symbols_of(kind));
    if (table.empty())
      return failure("",
                     "the recordings do not give a table for runs of kind " + std::to_string(kind),
                     "take longer recordings");
    std::string hex;
    for (const char byte : table) {
      std::array<char, 3> digits{};
      std::snprintf(digits.data(), digits.size(), "%02x", static_cast<unsigned char>(byte));
      hex += digits.data();
    }
    std::puts(hex.c_str());
    tables.report.push_back(hex);
  }
  return tables;
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
