#include "baselines/device_nets.h"

#include <algorithm>

namespace obby::baselines {

Result<const float*> DeviceNets::parameters(const nn::Network<float>& net) {
  const auto isOfNet = [&](const Copy& c) { return c.net == &net; };
  auto copy = std::find_if(copies_.begin(), copies_.end(), isOfNet);
  if (copy == copies_.end()) copy = copies_.insert(copy, Copy{&net, 0, {}});
  if (copy->version != net.version()) {
    OBBY_RETURN_IF_ERROR(copy->parameters.make(device_, net.parameters().size()));
    OBBY_RETURN_IF_ERROR(copy->parameters.put(net.parameters()));
    copy->version = net.version();
  }
  return static_cast<const float*>(copy->parameters.data());
}

Status DeviceRows::forward(DeviceNets& nets, const nn::Network<float>& net, const float* inputs,
                           size_t rows) {
  const size_t count = rows * net.inputs(0);
  OBBY_ASSIGN(const float* const parameters, nets.parameters(net));
  OBBY_RETURN_IF_ERROR(inputs_.make(nets.device(), count));
  OBBY_RETURN_IF_ERROR(inputs_.put({inputs, count}));
  OBBY_RETURN_IF_ERROR(pass_.reserve(nets.device(), net, uint32_t(rows), uint32_t(rows)));
  OBBY_RETURN_IF_ERROR(pass_.forward(parameters, inputs_.data(), uint32_t(rows)));
  OBBY_ASSIGN(outputs_, sim::downloadTable(nets.device(), pass_.outputs(), rows * net.outputs()));
  return {};
}

Status DeviceRows::backward(DeviceNets& nets, const nn::Network<float>& net, const float* gradient,
                            std::vector<float>& sums, float* inputGradient) {
  OBBY_ASSIGN(const float* const parameters, nets.parameters(net));
  OBBY_RETURN_IF_ERROR(
      nets.device().upload(pass_.outputGradient(), gradient, outputs_.size() * sizeof(float)));
  OBBY_RETURN_IF_ERROR(sums_.make(nets.device(), sums.size()));
  if (inputGradient != nullptr)
    OBBY_RETURN_IF_ERROR(inputGradient_.make(nets.device(), inputs_.size()));
  const auto rows = uint32_t(outputs_.size() / net.outputs());
  OBBY_RETURN_IF_ERROR(pass_.backward(parameters, inputs_.data(), rows, sums_.data(),
                                      inputGradient == nullptr ? nullptr : inputGradient_.data()));
  OBBY_ASSIGN(const std::vector<float> found, sums_.get());
  if (inputGradient != nullptr) {
    OBBY_ASSIGN(const std::vector<float> below, inputGradient_.get());
    std::copy(below.begin(), below.end(), inputGradient);
  }
  for (size_t i = 0; i < sums.size(); ++i) sums[i] += found[i];
  return {};
}

}  // namespace obby::baselines
