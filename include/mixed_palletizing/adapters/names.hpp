// Names of topics, services, actions and frames; relative, so that launch files and namespaces remap them.
#pragma once

namespace mixed_palletizing::adapters::names {

// Detector, in the node's namespace.
constexpr char kPoints[] = "points";
constexpr char kBoxes[] = "boxes";
constexpr char kMarkers[] = "markers";
constexpr char kLabels[] = "labels";

// Detector, private.
constexpr char kCalibrate[] = "calibrate";
constexpr char kDetect[] = "detect";
constexpr char kTuning[] = "tuning";
constexpr char kMarkerImage[] = "marker_image";
constexpr char kDebugPrefix[] = "debug/";

// Planner, private.
constexpr char kStartPallet[] = "start_pallet";
constexpr char kChooseNextPick[] = "choose_next_pick";
constexpr char kReportPick[] = "report_pick";
constexpr char kUndoLast[] = "undo_last";
constexpr char kGetPalletState[] = "get_pallet_state";
constexpr char kClosePallet[] = "close_pallet";
constexpr char kPlanPallet[] = "plan_pallet";
constexpr char kPalletState[] = "pallet_state";
constexpr char kPalletMarkers[] = "pallet_markers";
constexpr char kLastDecision[] = "last_decision";

// Converters.
constexpr char kDetections[] = "detections";
constexpr char kBoundingBoxes[] = "bounding_boxes";
constexpr char kPlanningScene[] = "planning_scene";

// Camera driver (Zivid's ROS 1 driver), in the camera's namespace.
constexpr char kPointsXyzrgba[] = "points/xyzrgba";
constexpr char kPointsXyz[] = "points/xyz";
constexpr char kColorImage[] = "color/image_color";
constexpr char kColorInfo[] = "color/camera_info";
constexpr char kDepthImage[] = "depth/image";
constexpr char kDepthInfo[] = "depth/camera_info";
constexpr char kCapture[] = "capture";
constexpr char kIsConnected[] = "is_connected";

// Simulated cell, in the camera's namespace.
constexpr char kTakeBox[] = "take_box";
constexpr char kTruth[] = "truth";

// Frames.
constexpr char kBaseFrame[] = "aruco_base";
constexpr char kPalletFrame[] = "pallet";
constexpr char kCameraFrame[] = "zivid_optical_frame";

}  // namespace mixed_palletizing::adapters::names
