// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QAction>
#include <QList>
#include <QObject>
#include <QString>

class QLabel;
class QPushButton;
class QToolButton;
class QWidget;

namespace ui::kit {

/// The table of the window's actions, each with text, shortcuts, tooltip, status tip and icon. Buttons, shortcuts and
/// the help overlay are generated from it, so they always agree.
class Actions : public QObject
{
    Q_OBJECT
public:
    struct Group
    {
        const char* name;
        QList<QAction*> actions;

        [[nodiscard]] QString title() const { return tr(name); }
    };

    /// @param window  the widget in which the shortcuts are active
    explicit Actions(QWidget* window);

    [[nodiscard]] const QList<Group>& groups() const { return m_groups; }
    /// Updates `pauseReplay`: it resumes the replay if that is paused, and pauses it otherwise.
    void showReplayPaused(bool paused);
    /// Updates `account` and all actions that depend on whether a user is logged in.
    /// @param username  empty: a guest
    void showAccount(const QString& username);
    /// Updates the icon and the tooltip of `devices`.
    /// @param drawing  name of the icon
    /// @param state    the device in use and its state
    void showDevice(const QString& drawing, const QString& state);
    [[nodiscard]] bool isGuest() const { return m_username.isEmpty(); }
    /// Where `back` leads from the current page.
    enum class Back { Tooth, Lessons, Attempts, Class };
    void showWayBack(Back to);
    /// Sets the tooltip of an action: its own if it is allowed, otherwise the reason why it is not available. Does not
    /// enable or disable the action; the window does.
    /// @param whyNot  empty: the lesson does not allow it
    static void setAllowed(QAction* aid, bool allowed, const QString& whyNot = {});
    /// Returns whether setAllowed() has forbidden an action.
    [[nodiscard]] static bool isRefused(const QAction* aid);
    /// Sets the indices of the favourite burs, which are available when the lesson names none, and stores them for the
    /// next run. Ignores invalid indices, and all after the fourth valid one.
    void setFavouriteBurs(const QList<int>& favourites);
    [[nodiscard]] const QList<int>& favouriteBurs() const { return m_favouriteBurs; }
    static constexpr int kMostFavouriteBurs = 4;
    /// Returns the indices of the burs that the panel shows and the keys 1 to 4 select: the first four that the lesson
    /// names, otherwise the favourites.
    [[nodiscard]] const QList<int>& bursAtHand() const
    {
        return m_lessonBurs.isEmpty() ? m_favouriteBurs : m_lessonBurs;
    }
    /// Calls setAllowed() for each bur.
    /// @param ids  ids of the allowed burs; empty: all are allowed
    void allowBurs(const std::vector<std::string>& ids);

    QAction* drill = nullptr;  ///< checkable: the bur runs
    QAction* otherHand = nullptr;
    QAction* bringHome = nullptr;  ///< hidden if the device cannot move the hand
    QAction* resetView = nullptr;
    QAction* recentreHead = nullptr;  ///< hidden while the view does not follow the head
    QList<QAction*> handpieces;       ///< checkable, exclusive; in the order of core::settings::handpieces(); visible
                                      ///< if available
    QList<QAction*> burs;             ///< checkable, exclusive; in the order of core::bur::burs()
    QAction* allBurs = nullptr;       ///< opens the bur picker
    QAction* undo = nullptr;
    QAction* redo = nullptr;
    QAction* reload = nullptr;
    QAction* grade = nullptr;
    QAction* lessons = nullptr;
    QAction* editLesson = nullptr;  ///< on the lessons page
    QAction* presets = nullptr;
    QAction* attempts = nullptr;   ///< hidden for a guest
    QAction* school = nullptr;     ///< hidden unless the user is an admin
    QAction* classes = nullptr;    ///< hidden if the user has no classes
    QAction* readAgain = nullptr;  ///< on the classes page
    QAction* search = nullptr;     ///< opens the lessons if the page has no search field
    QAction* chooseTooth = nullptr;
    QAction* mouth = nullptr;  ///< hidden if there is no OpenGL to draw the mouth
    QAction* openScan = nullptr;
    QAction* saveRecording = nullptr;
    QAction* saveReference = nullptr;
    QAction* openRecording = nullptr;
    QAction* history = nullptr;  ///< checkable: the undo history is shown
    // Actions of the replay. Hidden and disabled if no recording is played, because their keys have other meanings
    // then.
    QAction* pauseReplay = nullptr;  ///< shares the space bar with `drill`: one of the two is always disabled
    QAction* stepBack = nullptr;
    QAction* stepOn = nullptr;
    QAction* replayBegin = nullptr;
    QAction* replayEnd = nullptr;
    QAction* slower = nullptr;
    QAction* faster = nullptr;
    QAction* beside = nullptr;   ///< checkable: another attempt is shown beside this one
    QAction* along = nullptr;    ///< checkable: the device guides the hand; hidden if it cannot
    QAction* expert = nullptr;   ///< also in practice; hidden in an exam, and if the lesson cuts nothing and has no
                                 ///< recording
    QAction* section = nullptr;  ///< checkable: the cross-section is shown
    QAction* turnSection = nullptr;
    QAction* radiograph = nullptr;
    QAction* outline = nullptr;  ///< checkable: the ideal preparation is outlined on the tooth
    QAction* turnRound = nullptr;
    // Actions of the view (ViewMenu). All but the last two are checkable.
    QAction* mirror = nullptr;
    QAction* burLight = nullptr;
    QAction* depthColours = nullptr;
    QAction* idealColours = nullptr;
    QAction* burColour = nullptr;
    QAction* fixture = nullptr;  ///< checkable: a force keeps the bur inside the outline
    QAction* handPlace = nullptr;
    QAction* neighbours = nullptr;
    QAction* distinctColours = nullptr;
    QAction* wetLook = nullptr;
    QAction* stereo = nullptr;
    QAction* flipLeftRight = nullptr;
    QAction* flipUpDown = nullptr;
    QAction* reducedMotion = nullptr;
    QAction* stereoPage = nullptr;
    QAction* savePicture = nullptr;
    QAction* panel = nullptr;  ///< checkable: the side panel is shown
    QAction* console = nullptr;
    QAction* settings = nullptr;
    QAction* devices = nullptr;  ///< its icon and tooltip show the device in use
    QAction* account = nullptr;  ///< shows the user; opens the account menu, or the login page for a guest
    QAction* lock = nullptr;
    QAction* sound = nullptr;  ///< checkable: the sound of the handpiece is on
    QAction* fullScreen = nullptr;
    QAction* help = nullptr;
    QAction* tour = nullptr;
    QAction* back = nullptr;
    QAction* quit = nullptr;

signals:
    /// Emitted when the key of `expert` is pressed while that action is disabled.
    void expertMissing();
    void bursAtHandChanged();

private:
    void addDrillActions();
    void addHandpieceActions();
    void addToothActions();
    void addReplayActions();
    void addInsideActions();
    void addViewActions();
    void addWindowActions();
    /// @param text, tip  marked for translation; translated again when the language changes
    QAction* add(const QString& drawing, const char* text, const char* tip, const QList<QKeySequence>& keys);
    QAction* add(const QString& drawing, std::function<QString()> text, const char* tip,
                 const QList<QKeySequence>& keys);
    void retranslateUi();
    void giveKeysToBurs();

    struct Words
    {
        QAction* action;
        std::function<QString()> text;
        const char* tip;
    };
    static void say(const Words& words);
    QWidget* m_window;
    QList<Group> m_groups;
    QList<int> m_favouriteBurs;
    QList<int> m_lessonBurs;
    QList<Words> m_words;
    [[nodiscard]] static QString tipOf(const QAction* action, const QString& what);
    [[nodiscard]] QString wayBack() const;
    QString m_username;
    Back m_back = Back::Tooth;
    bool m_isReplayPaused = false;
};

/// Calls `say` now, and again whenever the text or the tooltip of the action changes.
void followWords(QAction* action, QWidget* listener, const std::function<void()>& say);

/// Returns a flat icon button for a bar of the practice room. Tab reaches it; a click leaves the focus on the tooth.
[[nodiscard]] QToolButton* barButton(QAction* action, bool withText, QWidget* parent);

/// Returns a label that says that nothing is saved. Hidden while a user is logged in.
[[nodiscard]] QLabel* guestSign(const Actions& actions, QWidget* parent);

/// Returns a push button for a page that triggers the action and shows its text and icon in the colours of the page.
/// @param kind  "filled", "quiet" or "" (see cusp.qss)
[[nodiscard]] QPushButton* pageButton(QAction* action, const char* kind, QWidget* parent);

}  // namespace ui::kit
