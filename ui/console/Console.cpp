// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/Console.h"

#include <algorithm>
#include <optional>

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QVBoxLayout>

#include "ui/charts/SaveButton.h"
#include "ui/console/ParameterWords.h"
#include "ui/console/WatchPanel.h"
#include "ui/kit/StandardFolders.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Search.h"

namespace ui::console {
namespace {

constexpr int kMostLines = 500;
constexpr int kMostHinted = 6;
constexpr int kMostHistory = 100;
constexpr std::size_t kNameWidth = 30;  ///< minimum width in characters
/// A translucent background. Text has a contrast of at least 4.5 to 1 whatever is below.
constexpr QColor kGround(14, 16, 17, 204);

const QStringList kCommands{QStringLiteral("export"),  QStringLiteral("get"),  QStringLiteral("help"),
                            QStringLiteral("list"),    QStringLiteral("load"), QStringLiteral("plot"),
                            QStringLiteral("reset"),   QStringLiteral("save"), QStringLiteral("set"),
                            QStringLiteral("unwatch"), QStringLiteral("watch")};
/// Commands that take the name of a parameter.
const QStringList kOfNames{QStringLiteral("export"),  QStringLiteral("get"),   QStringLiteral("list"),
                           QStringLiteral("plot"),    QStringLiteral("reset"), QStringLiteral("set"),
                           QStringLiteral("unwatch"), QStringLiteral("watch")};

/// Commands that take the name of a preset, which may contain spaces.
bool isOfPresets(const QString& line)
{
    return line.startsWith(u"load ") || line.startsWith(u"save ");
}

/// Returns the beginning of the word that Tab completes.
qsizetype begunAt(const QString& line)
{
    return (isOfPresets(line) ? line.indexOf(u' ') : line.lastIndexOf(u' ')) + 1;
}

/// Parses a number written with a point or in the format of the window's language. A switch may be "on" or "off".
std::optional<double> numberIn(const QString& text, bool isSwitch)
{
    bool isNumber = false;
    if (isSwitch && (text == u"on" || text == u"off"))
        return text == u"on" ? 1.0 : 0.0;
    double value = QLocale::c().toDouble(text, &isNumber);
    if (!isNumber)
        value = QLocale().toDouble(text, &isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
}

QString commonBeginning(const QStringList& all)
{
    QString common = all.front();
    for (const QString& one : all)
        while (!one.startsWith(common))
            common.chop(1);
    return common;
}

}  // namespace

Console::Console(const core::settings::Parameters& parameters, WatchPanel& panel, QWidget* parent)
    : QWidget(parent), m_parameters(parameters), m_panel(panel), m_output(new QPlainTextEdit(this)),
      m_hint(new QLabel(this)), m_line(new QLineEdit(this))
{
    kit::dress(*this, kit::roomPalette());  // dark in both themes, because it covers the tooth
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPixelSize(kit::kBody - 1);
    m_output->setReadOnly(true);
    m_output->setFrameShape(QFrame::NoFrame);
    m_output->setFont(fixed);
    m_output->setMaximumBlockCount(kMostLines);
    m_output->setFocusPolicy(Qt::NoFocus);
    m_output->setObjectName(QStringLiteral("consoleOutput"));
    m_output->setProperty("kind", "overlay");
    m_hint->setFont(kit::typeface(kit::kSmall));
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_hint->setTextFormat(Qt::PlainText);
    m_hint->setWordWrap(true);
    m_hint->setObjectName(QStringLiteral("consoleHint"));
    m_line->setFont(fixed);
    m_line->setObjectName(QStringLiteral("consoleLine"));
    m_line->setProperty("kind", "overlay");
    m_line->installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kit::kSpace4, kit::kSpace2, kit::kSpace4, kit::kSpace2);
    column->setSpacing(kit::kSpace1);
    column->addWidget(m_output, 1);
    column->addWidget(m_hint);
    column->addWidget(m_line);
    connect(m_line, &QLineEdit::textChanged, this, &Console::hint);
    connect(m_line, &QLineEdit::returnPressed, this, [this] {
        const QString typed = m_line->text().trimmed();
        m_line->clear();
        if (typed.isEmpty())
            return;
        if (m_history.isEmpty() || m_history.back() != typed)
            m_history << typed;
        if (m_history.size() > kMostHistory)
            m_history.removeFirst();
        m_recalled = m_history.size();
        execute(typed);
    });
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("Console"));
        m_output->setAccessibleName(tr("Answers of the console"));
        m_line->setAccessibleName(tr("Command"));
        m_line->setPlaceholderText(tr("Type a command; Tab completes, \"help\" explains"));
        hint();
    });
    hide();
}

void Console::setPresets(Preset save, Preset load, PresetNames names)
{
    m_save = std::move(save);
    m_load = std::move(load);
    m_presetNames = std::move(names);
}

void Console::open()
{
    if (m_output->document()->isEmpty())
        say(tr("Parameters can be looked at and turned here while you drill. \"help\" lists the commands."));
    show();
    raise();
    m_line->setFocus();
}

void Console::execute(const QString& line)
{
    say(QStringLiteral("> ") + line);
    const QStringList words = line.simplified().split(u' ', Qt::SkipEmptyParts);
    if (words.isEmpty())
        return;
    const QString& command = words.front();
    const QString rest = words.mid(1).join(u' ');
    const bool wantsName =
        command == u"get" || command == u"watch" || command == u"plot" || command == u"save" || command == u"load";
    if (wantsName && rest.isEmpty()) {
        say(tr("\"%1\" wants a name behind it.").arg(command));
    } else if (command == u"list") {
        list(rest);
    } else if (command == u"get") {
        get(rest);
    } else if (command == u"set") {
        if (words.size() == 3)
            set(words[1], words[2]);
        else
            say(tr("Write \"set NAME VALUE\", as in \"set force.stiffness 1.5\"."));
    } else if (command == u"reset") {
        reset(rest);
    } else if (command == u"watch" || command == u"plot") {
        watch(rest, command == u"plot");
    } else if (command == u"export") {
        if (words.size() > 2)
            exportPlot(words[1], words.mid(2).join(u' '));
        else
            say(tr("Write \"export NAME FILE\", as in \"export live.force force.csv\"."));
    } else if (command == u"unwatch") {
        m_panel.forget(rest);
    } else if (command == u"save" || command == u"load") {
        if (const QString answer = askForPreset(command == u"save" ? m_save : m_load, rest); !answer.isEmpty())
            say(answer);
    } else if (command == u"help") {
        say(tr("list [TEXT]      the parameters whose name holds the text\n"
               "get NAME         its value, range and what it does\n"
               "set NAME VALUE   sets it\n"
               "reset [NAME]     sets it, or everything that is felt, back\n"
               "watch NAME       shows it over the view\n"
               "plot NAME        draws its last ten seconds over the view\n"
               "export NAME FILE saves what is plotted: .csv, .svg or .png\n"
               "unwatch [NAME]   takes it, or everything, away\n"
               "save NAME        keeps what is felt as a hardness preset\n"
               "load NAME        feels a hardness preset that is kept"));
        say(tr("Page Up and Page Down turn over the answers, Up and Down what was typed."));
    } else if (m_parameters.find(command.toStdString()) != nullptr) {
        words.size() == 2 ? set(command, words[1]) : get(command);
    } else {
        say(tr("There is no command \"%1\". \"help\" lists those there are.").arg(command));
    }
}

/// Runs a request for a preset by name. Returns the reason if it is refused, otherwise an empty string; the answer
/// arrives through say().
QString Console::askForPreset(const Preset& what, const QString& name)
{
    if (isFeelVeiled(m_parameters))
        return blindWords();
    return what ? what(name) : tr("Presets are not to be had here.");
}

void Console::list(const QString& text)
{
    const auto found = m_parameters.matching(text.toStdString());
    if (found.empty())
        say(tr("No parameter's name holds \"%1\".").arg(text));
    QStringList lines;
    std::size_t widest = kNameWidth;
    for (const core::settings::Parameter* parameter : found)
        widest = std::max(widest, parameter->name.size() + 2);
    for (const core::settings::Parameter* parameter : found)
        lines << QString::fromStdString(parameter->name).leftJustified(static_cast<qsizetype>(widest)) +
                     valueWords(*parameter, parameter->read());
    if (!lines.isEmpty())
        say(lines.join(u'\n'));
}

void Console::get(const QString& name)
{
    const core::settings::Parameter* parameter = m_parameters.find(name.toStdString());
    if (parameter == nullptr) {
        say(answerWords({core::settings::SetAnswer::Outcome::Unknown, {}}, name, nullptr));
        return;
    }
    if (const QString withheld = withheldWords(*parameter); !withheld.isEmpty()) {
        say(withheld);
        return;
    }
    say(QStringLiteral("%1 = %2   (%3)\n%4")
            .arg(name, valueWords(*parameter, parameter->read()), rangeWords(*parameter),
                 QString::fromStdString(parameter->help())));
}

void Console::set(const QString& name, const QString& value)
{
    const core::settings::Parameter* parameter = m_parameters.find(name.toStdString());
    const auto number = numberIn(value, parameter != nullptr && parameter->isSwitch);
    if (!number && parameter != nullptr) {
        say(tr("\"%1\" is no number.").arg(value) + u' ' +
            answerWords({core::settings::SetAnswer::Outcome::NotANumber, {}}, name, parameter));
        return;
    }
    const core::settings::SetAnswer answer = m_parameters.set(name.toStdString(), number.value_or(0.0));
    const QString refused = answerWords(answer, name, parameter);
    if (parameter != nullptr && refused.isEmpty())
        say(QStringLiteral("%1 = %2").arg(name, valueWords(*parameter, parameter->read())));
    else
        say(refused);
}

/// Resets a parameter. Without a name, resets all parameters of force and hardness, but not those of the view.
void Console::reset(const QString& name)
{
    if (!name.isEmpty()) {
        const core::settings::Parameter* parameter = m_parameters.find(name.toStdString());
        const QString refused = answerWords(m_parameters.reset(name.toStdString()), name, parameter);
        say(refused.isEmpty() ? QStringLiteral("%1 = %2").arg(name, valueWords(*parameter, parameter->read()))
                              : refused);
        return;
    }
    // Stiffness and damping limit each other. A value that cannot be reset in the first round can be reset in the
    // second.
    QString refused;
    for (int round = 0; round < 2; ++round) {
        refused.clear();
        for (const char* group : {"force.", "hardness."})
            for (const core::settings::Parameter* parameter : m_parameters.beginningWith(group)) {
                const QString said = answerWords(m_parameters.reset(parameter->name),
                                                 QString::fromStdString(parameter->name), parameter);
                refused = said.isEmpty() ? refused : said;
            }
    }
    say(refused.isEmpty() ? tr("All that is felt is as the preset says.") : refused);
}

void Console::watch(const QString& name, bool plotted)
{
    const core::settings::Parameter* parameter = m_parameters.find(name.toStdString());
    if (parameter == nullptr)
        say(answerWords({core::settings::SetAnswer::Outcome::Unknown, {}}, name, nullptr));
    else if (const QString withheld = withheldWords(*parameter); !withheld.isEmpty())
        say(withheld);
    else if (!m_panel.watch(name, plotted))
        say(tr("There is room for %1. Take one away with \"unwatch NAME\".").arg(WatchPanel::kMost));
}

/// Exports a plot, by default as a table in the user's documents folder.
void Console::exportPlot(const QString& name, const QString& file)
{
    const core::settings::Parameter* parameter = m_parameters.find(name.toStdString());
    if (const QString withheld = parameter != nullptr ? withheldWords(*parameter) : QString(); !withheld.isEmpty()) {
        say(withheld);
        return;
    }
    const auto chart = m_panel.chart(name);
    if (!chart) {
        say(tr("%1 is not plotted. \"plot %1\" begins it; then it can be saved.").arg(name));
        return;
    }
    static const QStringList kEndings{QStringLiteral("csv"), QStringLiteral("png"), QStringLiteral("svg")};
    const bool hasEnding = kEndings.contains(QFileInfo(file).suffix().toLower());
    const QString path = QDir(kit::documentsFolder()).filePath(hasEnding ? file : file + QStringLiteral(".csv"));
    if (QFileInfo::exists(path)) {
        say(tr("There is a file %1 already; choose another name.").arg(QDir::toNativeSeparators(path)));
        return;
    }
    const charts::Written written = charts::writeChart(*chart, path);
    say(written.isDone ? tr("Saved as %1.").arg(QDir::toNativeSeparators(path)) : written.told);
}

QStringList Console::candidates(const QString& line) const
{
    const qsizetype space = line.indexOf(u' ');
    QStringList found;
    const QString begun = line.mid(begunAt(line));
    if (isOfPresets(line)) {
        for (const QString& name : m_presetNames ? m_presetNames() : QStringList())
            if (text::plain(name).startsWith(text::plain(begun)))
                found << name;
        return found;
    }
    if (space < 0) {
        for (const QString& command : kCommands)
            if (command.startsWith(begun))
                found << command;
    } else if (!kOfNames.contains(line.left(space)) || line.count(u' ') != 1) {
        return {};
    }
    if (begun.isEmpty() && space < 0)
        return found;
    for (const core::settings::Parameter* parameter : m_parameters.beginningWith(begun.toStdString()))
        found << QString::fromStdString(parameter->name);
    // If no name begins with the word, names that contain it are candidates.
    if (found.isEmpty())
        for (const core::settings::Parameter* parameter : m_parameters.matching(begun.toStdString()))
            found << QString::fromStdString(parameter->name);
    return found;
}

QString Console::completed(const QString& line) const
{
    const QStringList found = candidates(line);
    if (found.isEmpty())
        return line;
    const qsizetype begin = begunAt(line);
    const QString common = commonBeginning(found);
    // Does not replace a word that several names contain by a common beginning without that word.
    if (found.size() > 1 && !common.contains(line.mid(begin)))
        return line;
    return line.left(begin) + common + (found.size() == 1 ? QStringLiteral(" ") : QString());
}

/// Shows the possible completions, or the parameter that the line names.
void Console::hint()
{
    const QString line = m_line->text();
    const QStringList words = line.simplified().split(u' ', Qt::SkipEmptyParts);
    for (const QString& word : words)
        if (const auto* parameter = m_parameters.find(word.toStdString())) {
            m_hint->setText(QStringLiteral("%1 · %2 · %3")
                                .arg(valueWords(*parameter, parameter->read()), rangeWords(*parameter),
                                     QString::fromStdString(parameter->help())));
            return;
        }
    const QStringList found = line.isEmpty() ? kCommands : candidates(line);
    const bool areMore = found.size() > kMostHinted && !line.isEmpty();
    m_hint->setText((areMore ? found.mid(0, kMostHinted) << QStringLiteral("…") : found).join(QStringLiteral("   ")));
}

void Console::say(const QString& text)
{
    m_output->appendPlainText(text);
    // The view scrolls by itself only if the last line was visible, and the hint below may have covered that line.
    m_output->verticalScrollBar()->setValue(m_output->verticalScrollBar()->maximum());
}

void Console::forget()
{
    m_line->clear();
    m_output->clear();
    m_history.clear();
    m_recalled = 0;
    m_panel.forget({});
    hide();
}

void Console::recall(int step)
{
    if (m_history.isEmpty())
        return;
    m_recalled = std::clamp<qsizetype>(m_recalled + step, 0, m_history.size());
    m_line->setText(m_history.value(m_recalled));
}

bool Console::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_line && event->type() == QEvent::ShortcutOverride) {
        // The key that opened the console closes it, so it does not type a character.
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_QuoteLeft) {
            event->ignore();
            return true;
        }
    }
    if (watched == m_line && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        switch (key->key()) {
        case Qt::Key_Up:
        case Qt::Key_Down:
            recall(key->key() == Qt::Key_Up ? -1 : 1);
            return true;
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
            m_output->verticalScrollBar()->triggerAction(
                key->key() == Qt::Key_PageUp ? QAbstractSlider::SliderPageStepSub : QAbstractSlider::SliderPageStepAdd);
            return true;
        case Qt::Key_Tab:
            // Tab leaves an empty line as usual. With text in the line it must not move the focus, because further keys
            // would act as shortcuts.
            if (m_line->text().isEmpty())
                break;
            m_line->setText(completed(m_line->text()));
            return true;
        case Qt::Key_QuoteLeft:
        case Qt::Key_Escape:
            emit closeRequested();
            return true;
        default:
            break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void Console::paintEvent(QPaintEvent*)
{
    QPainter(this).fillRect(rect(), kGround);
}

}  // namespace ui::console
