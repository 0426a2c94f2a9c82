// The panel as rviz loads it, clicked through against the real detector and planner of a simulated cell.
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest>
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <pluginlib/class_loader.hpp>
#include <ros/ros.h>
#include <rviz/panel.h>

#include <mixed_palletizing/BoxArray.h>
#include <mixed_palletizing/GetPalletState.h>

namespace {

constexpr int kAnswerMs = 60000;

class CellPanelTest : public testing::Test {
 protected:
  CellPanelTest()
      : loader_("rviz", "rviz::Panel"), panel_(loader_.createUniqueInstance("mixed_palletizing/CellPanel")) {
    panel_->resize(420, 640);
    panel_->show();
  }

  template <typename Widget>
  Widget& the(const char* name) {
    auto* widget = panel_->findChild<Widget*>(name);
    if (widget == nullptr) throw std::runtime_error(std::string("no widget ") + name);
    return *widget;
  }

  std::string text(const char* label) { return the<QLabel>(label).text().toStdString(); }

  static bool waitFor(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kAnswerMs);
  }

  /// Clicks and waits for the end of what it began. The window stays alive meanwhile.
  void click(const char* name) {
    auto& button = the<QPushButton>(name);
    ASSERT_TRUE(waitFor([&] { return button.isEnabled(); })) << name << ": " << text("status");
    QTest::mouseClick(&button, Qt::LeftButton);
    EXPECT_FALSE(the<QPushButton>("calibrate").isEnabled()) << "the click waited";
    ASSERT_TRUE(waitFor([&] { return the<QPushButton>("calibrate").isEnabled(); })) << name;
  }

  /// Answers the question that comes up after a click.
  void answer(const char* name, QMessageBox::StandardButton choice) {
    auto& button = the<QPushButton>(name);
    ASSERT_TRUE(waitFor([&] { return button.isEnabled(); })) << name << ": " << text("status");
    QTest::mouseClick(&button, Qt::LeftButton);
    QMessageBox* question = nullptr;
    ASSERT_TRUE(waitFor([&] { return (question = panel_->findChild<QMessageBox*>()) != nullptr; })) << name;
    QTest::mouseClick(question->button(choice), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return panel_->findChild<QMessageBox*>() == nullptr; })) << name;
  }

  static mixed_palletizing::PalletState planner() {
    mixed_palletizing::GetPalletState both;
    EXPECT_TRUE(ros::service::call("pick_planner/get_pallet_state", both));
    return both.response.state;
  }

  pluginlib::ClassLoader<rviz::Panel> loader_;
  pluginlib::UniquePtr<rviz::Panel> panel_;
};

TEST_F(CellPanelTest, RunsAPallet) {
  ASSERT_TRUE(ros::service::waitForService("box_detector/calibrate", 30000));
  ASSERT_TRUE(ros::service::waitForService("pick_planner/close_pallet", 30000));
  ASSERT_TRUE(ros::service::waitForService("zivid_camera/capture", 60000));
  click("calibrate");
  EXPECT_NE(text("status").find("floor within"), std::string::npos) << text("status");
  click("detect");
  EXPECT_NE(text("status").find("3 boxes"), std::string::npos) << text("status");
  EXPECT_FALSE(the<QPushButton>("next").isEnabled()) << "no pallet is open";

  the<QLineEdit>("order_file").setText(QString::fromStdString(ros::param::param<std::string>("~orders", "")));
  click("start");
  ASSERT_TRUE(waitFor([&] { return the<QPushButton>("next").isEnabled(); })) << text("status");
  EXPECT_FALSE(the<QPushButton>("placed").isEnabled());

  click("next");
  EXPECT_TRUE(waitFor([&] { return the<QTableWidget>("options").rowCount() == 3; }));
  ASSERT_TRUE(waitFor([&] { return the<QPushButton>("placed").isEnabled(); })) << text("status");
  ASSERT_EQ(planner().has_pending, 1);
  const auto there = ros::topic::waitForMessage<mixed_palletizing::BoxArray>("zivid_camera/truth");
  click("placed");
  EXPECT_NE(text("status").find("simulated robot: took"), std::string::npos) << text("status");
  EXPECT_NE(ros::topic::waitForMessage<mixed_palletizing::BoxArray>("zivid_camera/truth")->boxes,
            there->boxes)
      << "the box is still in the pick area";
  ASSERT_TRUE(waitFor([&] { return the<QProgressBar>("order").value() == 1; })) << text("pallet");
  EXPECT_EQ(planner().placements.size(), 1u);
  EXPECT_GT(the<QProgressBar>("utilization").value(), 0);
  EXPECT_FALSE(the<QPushButton>("placed").isEnabled()) << "reported already";
  const std::string picture = ros::param::param<std::string>("~screenshot", "");
  if (!picture.empty()) {
    EXPECT_TRUE(panel_->grab().save(QString::fromStdString(picture)));
  }

  click("undo");
  ASSERT_TRUE(waitFor([&] { return the<QProgressBar>("order").value() == 0; })) << text("pallet");
  EXPECT_TRUE(planner().placements.empty());
  answer("close", QMessageBox::No);
  EXPECT_EQ(planner().is_open, 1) << "the order is not complete";
  answer("close", QMessageBox::Yes);
  ASSERT_TRUE(waitFor([&] { return planner().is_open == 0 && the<QPushButton>("calibrate").isEnabled(); }))
      << text("status");
  EXPECT_NE(text("status").find("0 placed"), std::string::npos) << text("status");
  EXPECT_EQ(planner().is_open, 0);
}

TEST_F(CellPanelTest, SaysWhatIsMissing) {
  click("start");
  EXPECT_NE(text("status").find("choose a file of orders"), std::string::npos) << text("status");
  the<QLineEdit>("order_file").setText("/nowhere.jsonl");
  click("start");
  EXPECT_NE(text("status").find("/nowhere.jsonl"), std::string::npos) << text("status");
  auto& cell = the<QLineEdit>("cell");
  QTest::keyClicks(&cell, "left");
  QTest::keyClick(&cell, Qt::Key_Return);
  click("detect");
  EXPECT_EQ(text("status"), "/left/box_detector/detect is not there: is the cell running?");
}

TEST_F(CellPanelTest, KeepsItsFields) {
  the<QLineEdit>("order_file").setText("/orders.jsonl");
  rviz::Config config;
  panel_->save(config);
  the<QLineEdit>("order_file").clear();
  panel_->load(config);
  EXPECT_EQ(the<QLineEdit>("order_file").text().toStdString(), "/orders.jsonl");
}

TEST_F(CellPanelTest, GoesAwayDuringACall) {
  ASSERT_TRUE(ros::service::waitForService("box_detector/calibrate", 30000));
  QTest::mouseClick(&the<QPushButton>("calibrate"), Qt::LeftButton);
  panel_.reset();
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rviz_panel_test", ros::init_options::NoSigintHandler);
  const ros::NodeHandle node;
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
