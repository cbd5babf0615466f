// What is the same for all heads of a stock: made once, when a head first needs it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "head/form.hpp"

namespace mien {

// What `build` gives, or gave under that name before. Few are kept: those used last. Any number of threads
// may ask. A stock without a store keeps nothing.
std::shared_ptr<const void> share_any_thing(const HeadStock& stock, const std::string& name,
                                            const std::function<std::shared_ptr<const void>()>& build);

// The same; a name stands for things of one type.
template <typename Build>
auto share_stock_thing(const HeadStock& stock, const std::string& name, const Build& build) {
  using Thing = decltype(build());
  return std::static_pointer_cast<const Thing>(share_any_thing(
      stock, name, [&]() -> std::shared_ptr<const void> { return std::make_shared<const Thing>(build()); }));
}

}  // namespace mien
