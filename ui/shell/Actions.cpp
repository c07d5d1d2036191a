// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/Actions.h"

#include <QActionGroup>
#include <QPushButton>
#include <QToolButton>

#include "core/drilling/Bur.h"
#include "core/settings/Handpiece.h"
#include "ui/shell/LineIcon.h"
#include "ui/shell/Theme.h"
#include "ui/text/Texts.h"

namespace ui::shell {
namespace {

constexpr const char* kDrawing = "drawing";
constexpr const char* kOwnTip = "ownTip";

QString drawingOf(const QAction* action)
{
    return action->property(kDrawing).toString();
}

}  // namespace

Actions::Actions(QWidget* window) : QObject(window), m_window(window)
{
    m_groups.push_back({tr("Drill"), {}});
    drill = add("drill", tr("Drill on or off"), tr("Let the bur turn, or stop it"), {Qt::Key_D, Qt::Key_Space});
    drill->setCheckable(true);
    undo = add("undo", tr("Undo"), tr("Take back the last stroke"), {Qt::CTRL | Qt::Key_Z});
    redo = add("redo", tr("Redo"), tr("Make the stroke again that was taken back"), {Qt::CTRL | Qt::SHIFT | Qt::Key_Z});
    history = add("history", tr("History"), tr("Show what can be gone back to, branches and all, or put it away"),
                  {Qt::Key_U});
    history->setCheckable(true);
    reload =
        add("reload", tr("Start again"), tr("Make the tooth whole again; undo brings your work back"), {Qt::Key_R});
    grade = add("grade", tr("Grade"), tr("Measure what you have cut and explain the grade"), {Qt::Key_G});

    m_groups.push_back({tr("Handpiece"), {}});
    auto* oneBur = new QActionGroup(this);
    int digit = Qt::Key_1;
    for (const core::drilling::Bur& bur : core::drilling::burs()) {
        const QString name = text::burName(bur.id);
        QAction* action = add({}, name, tr("Take this bur"), {QKeySequence(digit++)});
        action->setCheckable(true);
        oneBur->addAction(action);
        burs.push_back(action);
    }
    auto* oneHandpiece = new QActionGroup(this);
    digit = Qt::Key_7;
    for (const core::settings::Handpiece& handpiece : core::settings::handpieces()) {
        QAction* action =
            add("handpiece", text::handpieceName(handpiece.name), tr("Take this handpiece"), {QKeySequence(digit++)});
        action->setCheckable(true);
        oneHandpiece->addAction(action);
        handpieces.push_back(action);
    }
    otherHand =
        add("hand", tr("Other hand"), tr("Hold the handpiece from the other side; the view stays"), {Qt::Key_H});
    otherHand->setCheckable(true);
    bringHome = add("home", tr("Lead the handpiece home"), tr("Let the handpiece lead your hand back over the tooth"),
                    {Qt::Key_C});

    m_groups.push_back({tr("Tooth and files"), {}});
    lessons = add("lessons", tr("Lessons"), tr("Choose what to practise"), {Qt::Key_F2});
    editLesson = add("edit", tr("Edit the lesson …"),
                     tr("Change the ideal and the marking of the lesson that is chosen in the list"), {Qt::Key_F4});
    presets = add("dials", tr("Hardness presets"), tr("Choose, try and change how drilling feels"), {Qt::Key_F7});
    chooseTooth = add("tooth", tr("Choose a tooth"), tr("Show the arches and choose one of 16 teeth"), {Qt::Key_T});
    mouth = add("mouth", tr("Whole mouth"), tr("Choose a tooth in the whole mouth, or go back to the flat arches"),
                {Qt::Key_M});
    openScan = add("open", tr("Open a scan"), tr("Open the scan of a tooth: OBJ, STL or PLY"), {Qt::CTRL | Qt::Key_O});
    saveRecording = add("save", tr("Save the recording"), tr("Save every movement of this attempt to a file"),
                        {Qt::CTRL | Qt::Key_S});
    saveReference =
        add("reference", tr("Save this attempt as the reference …"),
            tr("Keep what you have cut as the ideal that lessons ask for"), {Qt::CTRL | Qt::SHIFT | Qt::Key_S});
    openRecording =
        add("play", tr("Open a recording"), tr("Watch a saved attempt again"), {Qt::CTRL | Qt::SHIFT | Qt::Key_O});
    expert = add("expert", tr("The expert's attempt"),
                 tr("Watch how an expert does it; in a replay, beside this attempt"), {Qt::Key_Y});

    m_groups.push_back({tr("Replay"), {}});
    pauseReplay =
        add("pause", tr("Pause the replay"), tr("Hold the recording where it is, or let it go on"), {Qt::Key_Space});
    stepBack = add("step-back", tr("A stroke back"), tr("Go back to the end of the stroke before, and hold there"),
                   {Qt::Key_Left, Qt::Key_Comma});
    stepOn = add("step-on", tr("A stroke on"), tr("Go on to the end of the next stroke, and hold there"),
                 {Qt::Key_Right, Qt::Key_Period});
    replayBegin = add("to-begin", tr("To the beginning"), tr("Go to the beginning of the recording"), {Qt::Key_Home});
    replayEnd = add("to-end", tr("To the end"), tr("Go to the end of the recording"), {Qt::Key_End});
    slower = add("slower", tr("Slower"), tr("Play the recording more slowly, down to a tenth"),
                 {Qt::Key_BracketLeft, Qt::Key_Down});
    faster = add("faster", tr("Faster"), tr("Play the recording faster, up to 16 times"),
                 {Qt::Key_BracketRight, Qt::Key_Up});
    beside = add("beside", tr("Another beside"), tr("Open another attempt beside this one, or put it away"),
                 {Qt::CTRL | Qt::Key_B});
    beside->setCheckable(true);
    along = add("along", tr("Be led along"), tr("Let the handpiece lead your hand along the attempt; a push lets go"),
                {Qt::Key_A});
    along->setCheckable(true);

    m_groups.push_back({tr("Seeing inside"), {}});
    section = add("section", tr("Section"), tr("Show a live cut through the bur, or put it away"), {Qt::Key_X});
    section->setCheckable(true);
    turnSection =
        add("view", tr("Turn the section"), tr("Turn the cut about the bur by 15 degrees"), {Qt::SHIFT | Qt::Key_X});
    radiograph = add("film", tr("X-ray"), tr("Show X-ray pictures of the tooth, before and now"), {Qt::Key_F});

    m_groups.push_back({tr("View"), {}});
    resetView = add("view", tr("View from the start"), tr("Turn the tooth back to where it began"), {Qt::Key_V});
    turnRound = add("turn", tr("Turn round"), tr("Look from the other side: half a circle"), {Qt::SHIFT | Qt::Key_H});
    const auto choice = [this](const QString& drawing, const QString& text, const QString& tip,
                               const QList<QKeySequence>& keys) {
        QAction* action = add(drawing, text, tip, keys);
        action->setCheckable(true);
        return action;
    };
    //: The small round mirror on a handle
    mirror = choice("mirror", tr("Dental mirror"),
                    tr("Take the mirror or put it away; drag its glass, with Shift to tilt it"), {Qt::Key_E});
    burLight = choice("light", tr("Light on the handpiece"), tr("Let the handpiece light the cavity"), {Qt::Key_L});
    depthColours = choice("depth", tr("Colours of depth"),
                          tr("Colour the cut by its depth and tell it under the pointer"), {Qt::Key_K});
    idealColours = choice("ideal", tr("Colours against the ideal"),
                          tr("Colour what is too deep and what is still to go, and tell it under the pointer"),
                          {Qt::SHIFT | Qt::Key_K});
    //: The bur tells by its colour how near it is to what is to be kept
    burColour = choice("target", tr("Colour the bur"), tr("Colour the bur by how near it is to what is to be kept"),
                       {Qt::Key_A});
    fixture = choice("rail", tr("Guided hand"), tr("Let a gentle force hold the hand within the outline"), {Qt::Key_Q});
    neighbours =
        choice("mouth", tr("Neighbouring teeth"), tr("Show the teeth beside this one, and the gum"), {Qt::Key_N});
    handPlace = choice("ghost", tr("Where the hand is"), tr("Show faintly where the hand holds the bur"), {Qt::Key_B});
    distinctColours = choice("palette", tr("Colours for every eye"),
                             tr("Give each tissue a colour and a pattern that nobody confuses"), {Qt::Key_P});
    //: The tooth as if it were wet
    wetLook = choice("drop", tr("Wet tooth"), tr("Let the tooth shine as if it were wet"), {Qt::Key_W});
    stereo = choice("glasses", tr("Stereo picture"), tr("One picture for each eye"), {Qt::Key_S});
    stereoPage = add("glasses", tr("Set up the stereo picture …"),
                     tr("Choose glasses or screen and fit it to your eyes"), {Qt::SHIFT | Qt::Key_S});
    flipLeftRight = choice("flip-h", tr("Turn left and right over"), tr("For a half-silvered mirror over the hand"),
                           {Qt::ALT | Qt::Key_H});
    flipUpDown = choice("flip-v", tr("Turn up and down over"), tr("For a screen that lies upside down over the hand"),
                        {Qt::ALT | Qt::Key_V});
    savePicture =
        add("picture", tr("Save a picture …"), tr("Save what the view shows as a PNG"), {Qt::CTRL | Qt::Key_P});
    reducedMotion = choice("calm", tr("Less motion"), tr("No gliding, no spinning bur"), {Qt::ALT | Qt::Key_M});

    m_groups.push_back({tr("Window"), {}});
    panel = add("panel", tr("Side panel"), tr("Show the figures, or put them away"), {Qt::Key_F9});
    panel->setCheckable(true);
    panel->setChecked(true);
    console = add("console", tr("Console"), tr("Look at parameters and turn them while you drill, or put it away"),
                  {Qt::Key_F10, Qt::Key_QuoteLeft});
    settings = add("settings", tr("Settings"), tr("Every setting with its range"), {Qt::CTRL | Qt::Key_Comma});
    account = add("account", {}, tr("Log in, or lock this place and let somebody else log in"), {Qt::CTRL | Qt::Key_L});
    showAccount({});
    fullScreen = add("fullscreen", tr("Full screen"), tr("Fill the whole screen"), {Qt::Key_F11});
    fullScreen->setCheckable(true);
    help = add("help", tr("Keys and mouse"), tr("Show what every key does"), {Qt::Key_F1});
    back =
        add("back", tr("Back to the tooth"), tr("Close what lies over the tooth; nothing is lost"), {Qt::Key_Escape});
    quit = add("close", tr("Quit"), tr("Close Cusp"), {Qt::CTRL | Qt::Key_Q});
}

void Actions::showReplayPaused(bool paused)
{
    pauseReplay->setText(paused ? tr("Resume the replay") : tr("Pause the replay"));
    pauseReplay->setIcon(lineIcon(paused ? QStringLiteral("play") : QStringLiteral("pause"), roomPalette()));
}

void Actions::showAccount(const QString& username)
{
    account->setText(username.isEmpty() ? tr("Log in") : username);
}

void Actions::setAllowed(QAction* aid, bool allowed, const QString& whyNot)
{
    if (!aid->property(kOwnTip).isValid())
        aid->setProperty(kOwnTip, aid->toolTip());
    aid->setToolTip(allowed            ? aid->property(kOwnTip).toString()
                    : whyNot.isEmpty() ? tr("This lesson does not allow it.")
                                       : whyNot);
}

QAction* Actions::add(const QString& drawing, const QString& text, const QString& tip, const QList<QKeySequence>& keys)
{
    auto* action = new QAction(text, this);
    action->setShortcuts(keys);
    action->setStatusTip(tip);
    //: Tooltip: what it does, then its key
    action->setToolTip(tr("%1 (%2)").arg(tip, keys.front().toString(QKeySequence::NativeText)));
    action->setProperty(kDrawing, drawing);
    action->setIcon(lineIcon(drawing, roomPalette()));
    m_window->addAction(action);
    m_groups.back().actions.push_back(action);
    return action;
}

QToolButton* barButton(QAction* action, bool withText, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setToolButtonStyle(withText ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    button->setIconSize({20, 20});
    button->setFocusPolicy(Qt::TabFocus);
    button->setAutoRaise(true);
    const auto name = [button, action] { button->setAccessibleName(action->text()); };
    name();
    QObject::connect(action, &QAction::changed, button, name);
    if (!action->isVisible())
        button->hide();
    QObject::connect(action, &QAction::visibleChanged, button,
                     [button, action] { button->setVisible(action->isVisible()); });
    button->setAccessibleDescription(action->toolTip());
    return button;
}

QPushButton* pageButton(QAction* action, const char* kind, QWidget* parent)
{
    auto* button = new QPushButton(action->text(), parent);
    button->setProperty("kind", kind);
    QPalette colours = parent->palette();
    if (qstrcmp(kind, "filled") == 0)
        colours.setColor(QPalette::Active, QPalette::ButtonText, colours.color(QPalette::HighlightedText));
    button->setIcon(lineIcon(drawingOf(action), colours));
    button->setIconSize({18, 18});
    button->setToolTip(action->toolTip());
    button->setStatusTip(action->statusTip());
    button->setAccessibleName(action->text());
    button->setAccessibleDescription(action->toolTip());
    button->setFocusPolicy(Qt::TabFocus);
    button->setAutoDefault(true);  // Enter presses it, too
    button->setEnabled(action->isEnabled());
    QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
    QObject::connect(action, &QAction::enabledChanged, button, &QPushButton::setEnabled);
    return button;
}

}  // namespace ui::shell
