// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/ViewMenu.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QMenu>
#include <QToolButton>

#include "ui/kit/Actions.h"
#include "ui/kit/AppSettings.h"
#include "ui/kit/LanguageMenu.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/tooth/Viewpoint.h"

namespace ui::practice {
namespace {

constexpr double kLeastApart = 0.005;
constexpr double kMostApart = 0.1;
constexpr double kNearest = 0.6;
constexpr double kFarthest = 1.6;

/// Limits the settings to values that are comfortable for two eyes, whatever the file contains.
void keepInBounds(render::Presentation& how)
{
    const auto bounded = [](double value, double low, double high, double otherwise) {
        return value >= low && value <= high ? value : otherwise;
    };
    how.apart = bounded(how.apart, kLeastApart, kMostApart, render::Presentation{}.apart);
    how.convergence = bounded(how.convergence, kNearest, kFarthest, render::Presentation{}.convergence);
}

}  // namespace

ViewMenu::ViewMenu(kit::Actions& actions, QWidget* window)
    : QObject(window), m_actions(actions), m_menu(new QMenu(window))
{
    kit::dress(*m_menu, kit::roomPalette());
    text::bindTranslation(m_menu, [this] { m_menu->setAccessibleName(tr("View")); });
    for (QAction* action : {actions.resetView, actions.turnRound, actions.recentreHead})
        m_menu->addAction(action);
    m_menu->addMenu(makeSides());
    m_menu->addSeparator();
    for (QAction* action : {actions.mirror, actions.neighbours, actions.burLight, actions.depthColours,
                            actions.idealColours, actions.burColour, actions.fixture, actions.handPlace})
        m_menu->addAction(action);
    m_menu->addSeparator();
    for (QAction* action : {actions.distinctColours, actions.wetLook})
        m_menu->addAction(action);
    m_menu->addSeparator();
    for (QAction* action : {actions.stereo, actions.stereoPage, actions.flipLeftRight, actions.flipUpDown})
        m_menu->addAction(action);
    m_menu->addSeparator();
    for (QAction* action : {actions.savePicture, actions.reducedMotion, actions.sound})
        m_menu->addAction(action);
    m_menu->addSeparator();
    for (QAction* action : {actions.presets, actions.settings, actions.console}) {
        m_menu->addAction(action);
        action->setIconVisibleInMenu(false);
    }
    m_menu->addMenu(new kit::LanguageMenu(m_menu));
    // Beside an icon a check mark would shrink to a faint box around it.
    for (QAction* action : this->actions())
        action->setIconVisibleInMenu(false);
    read();
    for (QAction* action : {actions.mirror, actions.burLight, actions.depthColours, actions.idealColours,
                            actions.burColour, actions.handPlace, actions.distinctColours, actions.wetLook,
                            actions.stereo, actions.flipLeftRight, actions.flipUpDown, actions.reducedMotion})
        connect(action, &QAction::triggered, this, &ViewMenu::take);
    connect(actions.neighbours, &QAction::triggered, this, [this](bool on) {
        m_choseNeighbours = on;
        take();
    });
    connect(actions.outline, &QAction::triggered, this, &ViewMenu::take);
    connect(actions.stereoPage, &QAction::triggered, this, &ViewMenu::stereoPageRequested);
}

QMenu* ViewMenu::makeSides()
{
    auto* sides = new QMenu(m_menu);
    constexpr std::array<std::pair<const char*, const char*>, 6> kSides{{{"occlusal", QT_TR_NOOP("Occlusal")},
                                                                         {"buccal", QT_TR_NOOP("Buccal")},
                                                                         {"lingual", QT_TR_NOOP("Lingual")},
                                                                         {"mesial", QT_TR_NOOP("Mesial")},
                                                                         {"distal", QT_TR_NOOP("Distal")},
                                                                         {"below", QT_TR_NOOP("Apical")}}};
    for (const auto& [name, words] : kSides) {
        QAction* side = sides->addAction(QString());
        connect(side, &QAction::triggered, this, [this, name = QLatin1String(name)] { emit sideRequested(name); });
        text::bindTranslation(sides, [side, words = words] { side->setText(tr(words)); });
    }
    text::bindTranslation(sides, [sides] { sides->setTitle(tr("Look from")); });
    return sides;
}

QList<QAction*> ViewMenu::actions() const
{
    QList<QAction*> all = m_menu->actions();
    all.removeIf([this](const QAction* action) {
        return action->isSeparator() || action == m_actions.presets || action == m_actions.settings ||
               action == m_actions.console;
    });
    return all;
}

tooth::ViewSettings ViewMenu::settings() const
{
    tooth::ViewSettings shown = m_settings;
    if (!m_aids.heatMap || (shown.look.depthColours == render::DepthColours::AgainstIdeal && !m_aids.ideal))
        shown.look.depthColours = render::DepthColours::Off;
    shown.look.idealOutline = shown.look.idealOutline && m_aids.ideal;
    shown.showsMirror = shown.showsMirror && m_aids.mirror;
    shown.showsMargin = shown.showsMargin && m_aids.burColour && m_aids.ideal;
    return shown;
}

void ViewMenu::setAllowed(const lessons::Aids& aids)
{
    m_aids = aids;
    emit chosen(settings());
}

void ViewMenu::colourAgainstIdeal(bool on)
{
    m_actions.depthColours->setChecked(false);
    m_actions.idealColours->setChecked(on);
    take();
}

void ViewMenu::outlineIdeal(bool on)
{
    m_actions.outline->setChecked(on);
    take();
}

void ViewMenu::showNeighbours(bool areWatched)
{
    m_actions.neighbours->setChecked(areWatched || m_choseNeighbours);
    take();
}

QToolButton* ViewMenu::makeButton(QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setIcon(kit::lineIcon(QStringLiteral("eye"), kit::roomPalette()));
    button->setIconSize({20, 20});
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(m_menu);
    text::bindTranslation(button, [button] {
        button->setText(tr("View"));
        button->setToolTip(tr("Choose what the view shows"));
        button->setAccessibleName(button->text());
        button->setAccessibleDescription(button->toolTip());
    });
    button->setObjectName(QStringLiteral("viewButton"));
    return button;
}

void ViewMenu::read()
{
    const QSettings kept = kit::memory();
    const auto isOn = [&](const char* key, bool otherwise = false) {
        return kit::recalled(kept, QLatin1String("view/") + QLatin1String(key), otherwise);
    };
    m_actions.burLight->setChecked(isOn("light", true));  // on by default, as on current turbines
    m_actions.depthColours->setChecked(isOn("depth"));
    m_actions.burColour->setChecked(isOn("margin"));
    m_actions.handPlace->setChecked(isOn("hand"));
    m_choseNeighbours = isOn("neighbours");
    m_actions.neighbours->setChecked(m_choseNeighbours);
    m_actions.distinctColours->setChecked(isOn("distinct"));
    m_actions.wetLook->setChecked(isOn("wet"));
    m_actions.flipLeftRight->setChecked(isOn("flipLeftRight"));
    m_actions.flipUpDown->setChecked(isOn("flipUpDown"));
    m_actions.reducedMotion->setChecked(isOn("littleMotion"));
    const int stereo = kept.value(QStringLiteral("view/stereo")).toInt();
    const int last = kept.value(QStringLiteral("view/stereoMode"), 1).toInt();
    if (last >= 1 && last <= static_cast<int>(render::Stereo::TopBottom))
        m_lastStereo = static_cast<render::Stereo>(last);
    m_actions.stereo->setChecked(stereo >= 1 && stereo <= static_cast<int>(render::Stereo::TopBottom));
    m_settings.presentation.apart = kept.value(QStringLiteral("view/eyesApart"), 0.0).toDouble();
    m_settings.presentation.convergence = kept.value(QStringLiteral("view/convergence"), 0.0).toDouble();
    keepInBounds(m_settings.presentation);
    take();
}

/// Stores the settings of the actions. The mirror is not stored: it is off at each start.
void ViewMenu::take()
{
    tooth::ViewSettings now = m_settings;
    now.look.burLight = m_actions.burLight->isChecked();
    now.look.isWet = m_actions.wetLook->isChecked();
    now.look.palette = m_actions.distinctColours->isChecked() ? render::Palette::Distinct : render::Palette::Natural;
    // Only one of the two colourings can be on: the one chosen last.
    const bool belowOriginal = m_actions.depthColours->isChecked();
    const bool againstIdeal = m_actions.idealColours->isChecked();
    const bool wasAgainstIdeal = m_settings.look.depthColours == render::DepthColours::AgainstIdeal;
    now.look.depthColours = againstIdeal && !(belowOriginal && wasAgainstIdeal) ? render::DepthColours::AgainstIdeal
                            : belowOriginal                                     ? render::DepthColours::BelowOriginal
                                                                                : render::DepthColours::Off;
    m_actions.depthColours->setChecked(now.look.depthColours == render::DepthColours::BelowOriginal);
    m_actions.idealColours->setChecked(now.look.depthColours == render::DepthColours::AgainstIdeal);
    now.look.idealOutline = m_actions.outline->isChecked();
    now.presentation.stereo = m_actions.stereo->isChecked() ? m_lastStereo : render::Stereo::Off;
    now.presentation.flipLeftRight = m_actions.flipLeftRight->isChecked();
    now.presentation.flipUpDown = m_actions.flipUpDown->isChecked();
    now.showsMargin = m_actions.burColour->isChecked();
    now.showsHand = m_actions.handPlace->isChecked();
    now.showsMirror = m_actions.mirror->isChecked();
    now.showsNeighbours = m_actions.neighbours->isChecked();
    now.movesLittle = m_actions.reducedMotion->isChecked();
    m_settings = now;
    QSettings kept = kit::memory();
    const auto keep = [&](const char* key, const QVariant& value) {
        kept.setValue(QLatin1String("view/") + QLatin1String(key), value);
    };
    keep("light", now.look.burLight);
    keep("depth", now.look.depthColours == render::DepthColours::BelowOriginal);
    keep("margin", now.showsMargin);
    keep("hand", now.showsHand);
    keep("neighbours", m_choseNeighbours);
    keep("distinct", now.look.palette == render::Palette::Distinct);
    keep("wet", now.look.isWet);
    keep("flipLeftRight", now.presentation.flipLeftRight);
    keep("flipUpDown", now.presentation.flipUpDown);
    keep("littleMotion", now.movesLittle);
    keep("stereo", static_cast<int>(now.presentation.stereo));
    keep("stereoMode", static_cast<int>(m_lastStereo));
    keep("eyesApart", now.presentation.apart);
    keep("convergence", now.presentation.convergence);
    emit chosen(settings());
}

void ViewMenu::setStereo(render::Stereo stereo, double apart, double convergence)
{
    m_settings.presentation.apart = apart;
    m_settings.presentation.convergence = convergence;
    keepInBounds(m_settings.presentation);
    if (stereo != render::Stereo::Off)
        m_lastStereo = stereo;
    m_actions.stereo->setChecked(stereo != render::Stereo::Off);
    take();
}

}  // namespace ui::practice
