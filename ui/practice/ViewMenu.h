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

/// What a person chooses about the view: the actions for it say what is wanted, a menu shows them, and they are found
/// again at the next start. Says when something was chosen.
class ViewMenu : public QObject
{
    Q_OBJECT
public:
    explicit ViewMenu(kit::Actions& actions, QWidget* window);

    /// What is to be shown: what was chosen and is allowed.
    [[nodiscard]] tooth::ViewSettings settings() const;
    /// All that the menu holds of the view; the pages of presets and settings and the console stand below it.
    [[nodiscard]] QList<QAction*> actions() const;
    /// What a lesson does not allow, or has not, is not shown, whatever was chosen.
    void setAllowed(const lessons::Aids& aids);
    /// A lesson begins with the colours against its ideal, or with none.
    void colourAgainstIdeal(bool on);
    /// A lesson with an ideal begins with its outline on the tooth. Not kept for the next start.
    void outlineIdeal(bool on);
    /// A lesson that watches the neighbouring teeth begins with them shown, any other lesson as the person chose.
    void showNeighbours(bool areWatched);
    /// The way to the eyes that switching stereo on brings.
    [[nodiscard]] render::Stereo stereoWay() const { return m_lastStereo; }
    /// A button with the menu, for a bar.
    [[nodiscard]] QToolButton* makeButton(QWidget* parent);
    /// Of the two eyes: how far apart, and where the plane of the screen lies (render::Presentation).
    void setStereo(render::Stereo stereo, double apart, double convergence);

signals:
    void chosen(const ui::tooth::ViewSettings& settings);
    void stereoPageRequested();
    /// The tooth is to be seen from a named side (tooth::viewpointNames()).
    void sideRequested(const QString& viewpoint);

private:
    QMenu* makeSides();
    void read();
    void take();

    kit::Actions& m_actions;
    QMenu* m_menu;
    tooth::ViewSettings m_settings;  ///< as chosen
    lessons::Aids m_aids;
    bool m_choseNeighbours = false;  ///< also while a lesson shows them by itself
    render::Stereo m_lastStereo = render::Stereo::RedCyan;
};

}  // namespace ui::practice
