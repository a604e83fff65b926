#include "cli/bench_results.hpp"

#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace breccia::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(Clock clock) {
  return clock == Clock::wall ? "wall time" : "processor time";
}

std::string line_of(const BenchmarkResult& result, const KernelTiming& timing) {
  const auto& kernel = timing.kernel;
  const bool in_cache = timing.bytes() < result.machine.cache;
  const auto share = in_cache ? "in cache" : fmt::format("{:.0f} %", 100.0 * result.bandwidth_share(timing));
  return fmt::format(
      "{:<16}  {:<8}  {:<6}  {:>4}  {:>9.0f}  {:>5}  {:>7}  {:>13.1f}  {:>7.1f}  {:>7.1f}  {:>6.1f}  {:>8}\n",
      name_of(kernel.formulation),
      kernel.formulation == Formulation::total_lagrangian ? name_of(kernel.instructions) : std::string_view("-"),
      breccia::name_of(kernel.mixing), kernel.dimensions, timing.points, kernel.terms, kernel.threads,
      timing.speed() / 1e6, timing.bytes_per_point, timing.bytes_per_point_and_step, timing.bandwidth() / 1e9, share);
}

Json json_of(const MemoryBandwidth& bandwidth) {
  return {{"triad_bytes_per_s", bandwidth.triad}, {"update_bytes_per_s", bandwidth.update}};
}

Json json_of(const BandwidthTiming& timing) {
  Json rounds = Json::array();
  for (const auto& round : timing.rounds) rounds.push_back(json_of(round));
  return {{"threads", timing.threads}, {"median", json_of(timing.median())}, {"rounds", std::move(rounds)}};
}

Json json_of(const BenchmarkResult& result, const KernelTiming& timing) {
  const auto& kernel = timing.kernel;
  Json json = {{"formulation", name_of(kernel.formulation)}};
  if (kernel.formulation == Formulation::total_lagrangian) json["instructions"] = name_of(kernel.instructions);
  json["mixing"] = breccia::name_of(kernel.mixing);
  json["dimensions"] = kernel.dimensions;
  json["points"] = timing.points;
  json["terms"] = kernel.terms;
  json["threads"] = kernel.threads;
  json["bytes_per_point"] = timing.bytes_per_point;
  json["bytes_per_point_and_step"] = timing.bytes_per_point_and_step;
  json["points_x_steps_per_s"] = {{"median", timing.speed()}, {"rounds", timing.speeds}};
  json["bytes_per_s"] = timing.bandwidth();
  json["share_of_bandwidth"] = result.bandwidth_share(timing);
  return json;
}

}  // namespace

std::string table_of(const BenchmarkResult& result) {
  const auto& [processor, cores, cache] = result.machine;
  auto text = fmt::format("{}, {} cores, last level of cache {:.0f} MB; {} process{}, {}\n\n", processor, cores,
                          cache / 1e6, result.processes, result.processes == 1 ? "" : "es", name_of(result.clock));
  text += "memory bandwidth [GB/s]\nthreads   triad  update\n";
  for (const auto& timing : result.bandwidths) {
    const auto [triad, update] = timing.median();
    text += fmt::format("{:>7}  {:>6.1f}  {:>6.1f}\n", timing.threads, triad / 1e9, update / 1e9);
  }
  text += fmt::format("\n{:<16}  {:<8}  {:<6}  {:>4}  {:>9}  {:>5}  {:>7}  {:>13}  {:>7}  {:>7}  {:>6}  {:>8}\n",
                      "formulation", "instruc-", "mixing", "dim.", "points", "terms", "threads", "10^6 points x",
                      "bytes a", "and", "GB/s", "of");
  text += fmt::format("{:<16}  {:<8}  {:<6}  {:>4}  {:>9}  {:>5}  {:>7}  {:>13}  {:>7}  {:>7}  {:>6}  {:>8}\n", "",
                      "tions", "", "", "", "", "", "steps / s", "point", "step", "", "memory's");
  for (const auto& timing : result.kernels) text += line_of(result, timing);
  text.pop_back();
  return text;
}

std::string json_of(const BenchmarkResult& result) {
  Json json = {{"breccia", BRECCIA_VERSION},    {"processor", result.machine.processor},
               {"cores", result.machine.cores}, {"cache_bytes", result.machine.cache},
               {"processes", result.processes}, {"clock", name_of(result.clock)}};
  for (const auto& timing : result.bandwidths) json["memory"].push_back(json_of(timing));
  for (const auto& timing : result.kernels) json["kernels"].push_back(json_of(result, timing));
  return json.dump(2);
}

}  // namespace breccia::cli
