// Status words of the planner's services; the numbers mean the same in all of them.
#pragma once

#include <cstdint>
#include <exception>

#include <ros/console.h>

#include <mixed_palletizing/planning/pallet_session.hpp>

#include "planner_diagnostics.hpp"

namespace mixed_palletizing::adapters {

std::uint8_t codeOf(planning::SessionStatus status);
std::uint8_t codeOf(planning::ChooseStatus status);

template <typename Response>
void fill(const planning::SessionReply& reply, std::uint64_t revision, Response& response) {
  response.status = codeOf(reply.status);
  response.message = reply.message;
  response.revision = revision;
}

/// Calls the body of a service; what it throws becomes the status FAILED, and an error on /diagnostics.
template <typename Response, typename Body>
bool guarded(const char* service, PlannerDiagnostics& diagnostics, Response& response, Body body) {
  try {
    body();
    diagnostics.answered(service);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM(service << ": " << error.what());
    diagnostics.failed(service, error.what());
    response.status = Response::FAILED;
    response.message = error.what();
  }
  return true;
}

}  // namespace mixed_palletizing::adapters
