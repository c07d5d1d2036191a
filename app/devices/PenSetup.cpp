// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/PenSetup.h"

#include "core/settings/PenSettings.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/PenCard.h"
#include "ui/kit/AppSettings.h"
#include "ui/tooth/ToothView.h"

namespace app {
namespace {

using core::settings::PenSettings;
using ui::devices::PenCard;
using ui::kit::memory;
using ui::tooth::ToothView;

const QString kPenCurveKey = QStringLiteral("pen/curve");

/// Returns the stored settings of the pen. A stored value out of range is replaced by the default value.
PenSettings storedPen()
{
    PenSettings settings;
    bool isNumber = false;
    const double curve = memory().value(kPenCurveKey).toDouble(&isNumber);
    if (isNumber && curve >= PenSettings::kLeastCurve && curve <= PenSettings::kMostCurve)
        settings.curve = curve;
    return settings;
}

}  // namespace

void connectPen(ui::window::MainWindow& window)
{
    PenCard* const card = &window.devicesPage().pen();
    ToothView* const view = &window.view();
    const PenSettings stored = storedPen();
    view->setPen(stored);
    card->setSettings(stored);
    card->setFullForce(view->hand().forceN());
    QObject::connect(view, &ToothView::handChanged, card, [card, view] { card->setFullForce(view->hand().forceN()); });
    QObject::connect(card, &PenCard::settingsChanged, view, [view](const PenSettings& settings) {
        memory().setValue(kPenCurveKey, settings.curve);
        view->setPen(settings);
    });
}

}  // namespace app
