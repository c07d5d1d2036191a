// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

class QFrame;
class QHBoxLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace ui::kit {
class Actions;
class FoldingBar;
class TabularDigitsLabel;
}  // namespace ui::kit
namespace ui::practice {
class HistoryPanel;
class LessonStrip;
class SidePanel;
class ViewMenu;
}  // namespace ui::practice

namespace ui::inside {
class SectionView;
}

namespace ui::replay {
class ReplayBar;
}  // namespace ui::replay

namespace ui::tooth {
class ToothView;
}

namespace ui::window {

/// The room in which one drills: the tooth fills it; a bar above says which tooth, a bar below holds the work's own
/// buttons, the side panel the figures. Dark grey in either theme.
///
/// While the tooth view is pressed, the room keeps its layout, so that the tooth never moves under the bur. Widgets
/// that open, close or change their size meanwhile are placed after the release.
class PracticeRoom : public QWidget
{
    Q_OBJECT
public:
    /// @param view  the tooth; becomes a child
    PracticeRoom(kit::Actions& actions, practice::ViewMenu& viewMenu, tooth::ToothView* view, QWidget* parent);

    [[nodiscard]] practice::SidePanel& panel() { return *m_panel; }
    [[nodiscard]] inside::SectionView& section() { return *m_section; }
    /// Above the tooth; hidden without a lesson.
    [[nodiscard]] practice::LessonStrip& lesson() { return *m_lesson; }
    /// In place of the work's own bar while a recording is played.
    [[nodiscard]] replay::ReplayBar& replay() { return *m_replay; }
    /// Over the tooth; hidden until it is wanted.
    [[nodiscard]] practice::HistoryPanel& history() { return *m_history; }
    /// Has its place beneath the tooth while it is visible.
    void setExercise(QWidget* card);
    /// Beside the view, while it is visible.
    void setTrial(QWidget* card);
    /// Shows another tooth to the right of ours, each with its name above it; null: none, and no names.
    void setBeside(QWidget* view, const QString& name = {});
    /// @param title  "Tooth 36", or the file
    /// @param name   "lower left first molar", or empty
    void setTooth(const QString& title, const QString& name);
    /// The line at the foot of the view that says how to begin.
    void setHintVisible(bool visible);
    /// The hint is about the mouse: with a force device it is hidden.
    void setHandHasForce(bool hasForce)
    {
        m_handHasForce = hasForce;
        setHintVisible(m_hintWanted);
    }
    /// Tells of harm where it happens, over the tooth, for as long as it takes to read it.
    void showNotice(const QString& what, const QString& whatToDo);
    /// Returns whether there was a notice to hide.
    bool hideNotice();
    /// What somebody remarked of the moment that is played, at the foot of the view; empty: nothing.
    void showRemark(const QString& words);
    void setReplaying(bool replaying);
    /// Puts the side panel away, or shows it.
    void setPanelVisible(bool visible);
    /// Shows the cross-section beside the tooth, or puts it away.
    void setSectionVisible(bool visible);
    /// Where the tooth is, in this widget's coordinates.
    [[nodiscard]] QRect viewArea() const;
    /// Returns the place that overlays must not cover, in this widget's coordinates: the bur while the view is pressed
    /// or a recording is played, and afterwards its last place. So a card does not move away from a pointer that comes
    /// to it.
    [[nodiscard]] const std::optional<QPointF>& burPlace() const { return m_bur; }

signals:
    /// Emitted when viewArea() or burPlace() has changed.
    void viewAreaChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void keepLayout(bool kept);
    void fitSection();
    QWidget* makeTopBar(const kit::Actions& actions);
    QWidget* makeBottomBar(const kit::Actions& actions, practice::ViewMenu& viewMenu);
    static QLabel* accountName(const kit::Actions& actions, QWidget* parent);
    void makeNotice();
    void placeOverlays();
    void placeNotice();
    void placeAtFoot(QLabel& words, const QRect& area) const;
    void followBur();

    tooth::ToothView* m_view;
    practice::SidePanel* m_panel;
    inside::SectionView* m_section;
    bool m_isSectionWanted = false;
    QWidget* m_trial = nullptr;
    practice::LessonStrip* m_lesson;
    QToolButton* m_tooth = nullptr;
    QLabel* m_name = nullptr;
    kit::FoldingBar* m_topBar = nullptr;
    QToolButton* m_saveReference = nullptr;
    QHBoxLayout* m_middle = nullptr;
    QVBoxLayout* m_viewColumn = nullptr;
    QWidget* m_beside = nullptr;
    QLabel* m_besideName = nullptr;  ///< above the tooth beside
    QLabel* m_ourName = nullptr;     ///< above ours, while there is one beside
    QWidget* m_workBar = nullptr;
    replay::ReplayBar* m_replay = nullptr;
    practice::HistoryPanel* m_history = nullptr;
    QLabel* m_hint = nullptr;
    QLabel* m_remark = nullptr;  ///< while a recording is played
    QFrame* m_notice = nullptr;
    QLabel* m_noticeWhat = nullptr;
    QLabel* m_noticeToDo = nullptr;
    QTimer m_noticeTimer;
    bool m_hintWanted = true;
    bool m_handHasForce = false;
    std::optional<QPointF> m_bur;
    bool m_areaIsNew = false;  ///< the view was resized after m_bur was set
};

}  // namespace ui::window
