// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/attempt/CurrentAttempt.h"
#include "app/devices/DeviceController.h"
#include "app/pages/PresetController.h"
#include "app/school/AttemptLimit.h"
#include "app/school/SchoolSession.h"
#include "app/threads/LatestRequest.h"
#include "core/session/LiveAssessmentLoop.h"
#include "core/session/SessionChannels.h"
#include "core/session/SessionLoop.h"
#include "ui/window/MainWindow.h"

namespace app {

/// The objects that every controller of an attempt uses. They must outlive the controllers. Ui thread.
struct AttemptContext
{
    ui::window::MainWindow& window;
    core::session::UiChannels& channels;
    core::session::SessionLoop& session;
    core::session::LiveAssessmentLoop& assessment;
    DeviceController& devices;
    PresetController& presets;
    CurrentAttempt& attempt;
    LatestRequest& loads;
    AttemptLimit& limit;
    const SchoolSession& school;
};

}  // namespace app
