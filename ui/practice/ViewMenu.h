// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include "lessons/Aids.h"
#include "ui/tooth/ViewSettings.h"

class QAction;
class QMenu;
class QToolButton;

namespace ui::kit {
class Actions;
}

namespace ui::practice {

/// The user's choices about the view. The actions hold them, a menu shows them, and they are stored between runs.
class ViewMenu : public QObject
{
    Q_OBJECT
public:
    explicit ViewMenu(kit::Actions& actions, QWidget* window);

    /// Returns the settings in effect: the user's choices that the lesson allows.
    [[nodiscard]] tooth::ViewSettings settings() const;
    /// Returns the actions of the view. The menu also has actions for the pages of presets and settings, and for the
    /// console.
    [[nodiscard]] QList<QAction*> actions() const;
    /// Restricts the settings to the aids that the lesson allows and provides.
    void setAllowed(const lessons::Aids& aids);
    /// Sets whether the tooth is coloured by its distance to the ideal. Called when a lesson begins.
    void colourAgainstIdeal(bool on);
    /// Sets whether the ideal is outlined. Called when a lesson begins; not stored.
    void outlineIdeal(bool on);
    /// Shows the adjacent teeth if the lesson checks that they are not touched; otherwise restores the user's choice.
    void showNeighbours(bool areWatched);
    /// Returns the stereo mode that is used when the user switches stereo on.
    [[nodiscard]] render::Stereo stereoWay() const { return m_lastStereo; }
    /// Returns a tool button that opens the menu.
    [[nodiscard]] QToolButton* makeButton(QWidget* parent);
    /// Sets the stereo mode, the distance between the eyes and the plane of the screen (see render::Presentation).
    void setStereo(render::Stereo stereo, double apart, double convergence);

signals:
    /// Emitted when the settings in effect have changed.
    void chosen(const ui::tooth::ViewSettings& settings);
    void stereoPageRequested();
    /// Emitted when the user requests the view from a named side (tooth::viewpointNames()).
    void sideRequested(const QString& viewpoint);

private:
    QMenu* makeSides();
    void read();
    void take();

    kit::Actions& m_actions;
    QMenu* m_menu;
    tooth::ViewSettings m_settings;  ///< the user's choices
    lessons::Aids m_aids;
    bool m_choseNeighbours = false;  ///< the user's choice, also while a lesson overrides it
    render::Stereo m_lastStereo = render::Stereo::RedCyan;
};

}  // namespace ui::practice
