#include "solve/learned/device_nets.h"

#include "solve/learned/device_kernels.h"
#include "solve/learned/device_steps.h"

namespace obby::solve::learned {

namespace {

template <class Arguments>
Status enqueue(DeviceNets& nets, LearnedStep step, const Arguments& arguments, size_t count) {
  return nets.device().enqueue(learnedKernel(step), &arguments, uint32_t(count));
}

Status upload(DeviceNets& nets, sim::Memory& to, const float* from, size_t count) {
  return sim::uploadTable(nets.device(), to, std::span(from, count));
}

Status fetch(DeviceNets& nets, std::vector<float>& to, const sim::Memory& from, size_t count) {
  to.resize(count);
  return nets.device().download(to.data(), from.address(), count * sizeof(float));
}

}  // namespace

Result<const float*> DeviceNets::numbers(const Net<float>& net) {
  const auto isOfNet = [&](const Copy& c) { return c.net == &net; };
  auto copy = std::find_if(copies_.begin(), copies_.end(), isOfNet);
  if (copy == copies_.end()) {
    copies_.push_back({&net, 0, {}});
    copy = copies_.end() - 1;
  }
  if (copy->version != net.version()) {
    OBBY_RETURN_IF_ERROR(upload(*this, copy->memory, net.numbers().data(), net.numbers().size()));
    copy->version = net.version();
  }
  return static_cast<const float*>(copy->memory.as<float>());
}

Status DevicePass::forward(DeviceNets& nets, const Net<float>& net, const float* inputs,
                           size_t rows) {
  OBBY_ASSIGN(const float* const numbers, nets.numbers(net));
  OBBY_RETURN_IF_ERROR(upload(nets, inputs_, inputs, rows * net.inputs(0)));
  units_.resize(net.layers());
  const float* in = inputs_.as<float>();
  for (size_t l = 0; l < net.layers(); ++l) {
    const size_t inner = net.inputs(l), width = net.outputs(l);
    const float* const weights = numbers + net.at(l);
    LayerArguments a{in,
                     weights,
                     weights + inner * width,
                     nullptr,
                     uint32_t(inner),
                     uint32_t(width),
                     l + 1 < net.layers()};
    OBBY_RETURN_IF_ERROR(sim::makeRoom(nets.device(), units_[l], a.out, rows * width));
    OBBY_RETURN_IF_ERROR(enqueue(nets, LearnedStep::layer, a, rows * width));
    in = a.out;
  }
  return fetch(nets, outputs_, units_.back(), rows * net.outputs());
}

Status DevicePass::backward(DeviceNets& nets, const Net<float>& net, size_t rows,
                            const float* slope, std::vector<float>& gradient, float* inputSlope) {
  const bool toInputs = inputSlope != nullptr;
  const size_t inputs = rows * net.inputs(0);
  slopes_.resize(net.layers() + 1);
  OBBY_RETURN_IF_ERROR(upload(nets, slopes_.back(), slope, rows * net.outputs()));
  OBBY_RETURN_IF_ERROR(upload(nets, gradient_, gradient.data(), gradient.size()));
  if (toInputs) OBBY_RETURN_IF_ERROR(upload(nets, slopes_[0], inputSlope, inputs));
  OBBY_RETURN_IF_ERROR(layersBack(nets, net, rows, toInputs));
  std::vector<float> sums, inputSums;
  OBBY_RETURN_IF_ERROR(fetch(nets, sums, gradient_, gradient.size()));
  if (toInputs) {
    OBBY_RETURN_IF_ERROR(fetch(nets, inputSums, slopes_[0], inputs));
    std::copy(inputSums.begin(), inputSums.end(), inputSlope);
  }
  gradient = std::move(sums);
  return {};
}

Status DevicePass::layersBack(DeviceNets& nets, const Net<float>& net, size_t rows, bool toInputs) {
  OBBY_ASSIGN(const float* const numbers, nets.numbers(net));
  for (size_t l = net.layers(); l-- > 0;) {
    const size_t inner = net.inputs(l), width = net.outputs(l);
    const float* const in = (l == 0 ? inputs_ : units_[l - 1]).as<float>();
    const float* const slope = slopes_[l + 1].as<float>();
    const GradientArguments g{in,
                              slope,
                              gradient_.as<float>() + net.at(l),
                              uint32_t(rows),
                              uint32_t(inner),
                              uint32_t(width)};
    OBBY_RETURN_IF_ERROR(enqueue(nets, LearnedStep::gradient, g, (inner + 1) * width));
    if (l == 0 && !toInputs) return {};
    BackArguments b{slope,   numbers + net.at(l), l > 0 ? in : nullptr,
                    nullptr, uint32_t(inner),     uint32_t(width)};
    if (l > 0) {
      OBBY_RETURN_IF_ERROR(sim::makeRoom(nets.device(), slopes_[l], b.out, rows * inner));
      OBBY_RETURN_IF_ERROR(nets.device().fill(b.out, 0, rows * inner * sizeof(float)));
    }
    b.out = slopes_[l].as<float>();
    OBBY_RETURN_IF_ERROR(enqueue(nets, LearnedStep::back, b, rows * inner));
  }
  return {};
}

}  // namespace obby::solve::learned
