#include "head/stock_things.hpp"

#include <gtest/gtest.h>

#include "shipped.hpp"

namespace mien {
namespace {

TEST(stock_things, are_made_once_for_a_name_and_its_data) {
  const HeadStock& stock = shipped().heads;
  int made = 0;
  const auto make = [&] { return ++made; };
  const auto one = share_stock_thing(stock, "test thing", make),
             again = share_stock_thing(stock, "test thing", make);
  EXPECT_EQ(*one, 1);
  EXPECT_EQ(one, again);
  EXPECT_EQ(*share_stock_thing(stock, "other test thing", make), 2);
  HeadStock other = stock;
  other.data = std::make_shared<const HeadData>(*stock.data);
  EXPECT_EQ(*share_stock_thing(other, "test thing", make), 3);
  other.starts = nullptr;
  EXPECT_EQ(*share_stock_thing(other, "test thing", make), 4);
  EXPECT_EQ(*share_stock_thing(other, "test thing", make), 5);
}

TEST(stock_things, that_were_not_used_for_long_go) {
  const HeadStock& stock = shipped().heads;
  int made = 0;
  const auto make = [&] { return ++made; };
  const std::weak_ptr<const int> first = share_stock_thing(stock, "old test thing", make);
  EXPECT_FALSE(first.expired());
  for (int i = 0; i < 40; ++i) share_stock_thing(stock, "test thing " + std::to_string(i), make);
  EXPECT_TRUE(first.expired());
  EXPECT_EQ(made, 41);
}

}  // namespace
}  // namespace mien
