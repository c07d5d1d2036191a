// SPDX-License-Identifier: GPL-3.0-or-later
// An invented language, for finding texts that are not translated or have too little room.
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QRegularExpression>
#include <QScrollArea>
#include <QTableView>
#include <QTranslator>
#include <QWidget>

#include "lessons/Lesson.h"
#include "ui/charts/ChartPanel.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/toothchooser/ArchView.h"

namespace pseudo {

/// Turns "Undo" into "[Ũñďø··]": no English letter remains, and the text is 40 per cent longer, as in other languages.
/// Placeholders, ampersands of shortcuts and markup are unchanged.
inline QString said(const QString& english)
{
    static const QString kPlain = QStringLiteral("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
    static const QString kStrange = QStringLiteral("àƀčďéƒğħîĵķľɱñøþʠŕšťũṽŵẋýžÀƁČĎÉƑĞĦÎĴĶĽṀÑØÞɊŔŠŤŨṼŴẊÝŽ");
    static const QRegularExpression kKept(QStringLiteral("%L?\\d+|%L?n|&\\w+;|<[^>]*>"));
    QString strange;
    qsizetype from = 0;
    const auto retranslateUi = [&](qsizetype to) {
        for (; from < to; ++from) {
            const qsizetype at = kPlain.indexOf(english[from]);
            strange += at < 0 ? english[from] : kStrange[at];
        }
    };
    for (auto kept = kKept.globalMatch(english); kept.hasNext();) {
        const auto match = kept.next();
        retranslateUi(match.capturedStart());
        strange += match.captured();
        from = match.capturedEnd();
    }
    retranslateUi(english.size());
    // Splits the filler into words, so that lines can break as in a real language.
    QString longer;
    for (qsizetype k = 0; k < (2 * english.size() + 4) / 5; ++k)
        longer += k % 9 == 8 ? u' ' : u'·';
    return u'[' + strange + longer + u']';
}

class Translator final : public QTranslator
{
public:
    using QTranslator::QTranslator;
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char*, const char* source, const char*, int) const override
    {
        return source == nullptr || *source == 0 ? QString() : said(QString::fromUtf8(source));
    }
};

inline lessons::LocalText said(const lessons::LocalText& text)
{
    lessons::LocalText strange;
    for (const auto& [code, words] : text)
        strange[code] = said(QString::fromStdString(words)).toStdString();
    return strange;
}

/// Translates texts that come from files and are not in a .ts file.
inline lessons::Rubric said(lessons::Rubric rubric)
{
    rubric.title = said(rubric.title);
    for (lessons::CriterionRule& rule : rubric.criteria)
        rule.title = said(rule.title);
    return rubric;
}

inline lessons::Lesson said(lessons::Lesson lesson)
{
    lesson.title = said(lesson.title);
    lesson.goal = said(lesson.goal);
    lesson.course = said(lesson.course);
    lesson.notModelled = said(lesson.notModelled);
    for (lessons::Step& step : lesson.steps) {
        step.text = said(step.text);
        step.hint = said(step.hint);
    }
    lesson.rubric = said(lesson.rubric);
    return lesson;
}

/// Returns the untranslated part of a text: English letters that are neither a name nor a unit.
inline QString untranslated(QString words)
{
    static const QRegularExpression kMarkup(QStringLiteral("<[^>]*>|&\\w+;"));
    static const QRegularExpression kExempt(
        QStringLiteral("\\b(?:"
                       "mm|ms|Hz|min|rpm|Cusp"  // units that are the same in all languages; the program
                       "|OBJ|STL|PLY|PNG"       // kinds of files
                       "|F\\d+|[A-Z]|Ctrl|Shift|Alt|Esc|Del|PgUp|PgDown"  // keys are named by Qt
                       "|English|Deutsch|Español"                         // languages are named in themselves
                       "|[0-9a-f]{12}"                                    // the beginning of a hash
                       "|\\d+[A-Z]?|FG|[A-Z]{1,3}\\d+"                    // numbers of burs
                       "|[\\w-]+\\.(?:json|sqlite|cusp\\w+)"              // files
                       ")\\b"));
    static const QRegularExpression kEnglish(QStringLiteral("[A-Za-z]{2,}"));
    words.remove(kMarkup).remove(u'&').remove(kExempt);
    return kEnglish.match(words).captured();
}

/// Returns all texts of a chart.
inline QStringList wordsOf(const ui::charts::Chart& chart)
{
    using namespace ui::charts;
    QStringList words{chart.title, chart.note, chart.emptyWords};
    for (const Dot& dot : stopsOf(chart))
        words << dot.words;
    const auto [across, up] = axesOf(chart);
    words << across.title << up.title;
    QList<Limit> limits;
    if (const auto* curve = std::get_if<Curve>(&chart.content)) {
        words << curve->band.name << curve->band.middleName;
        for (const Line& line : curve->lines)
            words << line.name;
        limits = curve->limits;
    }
    if (const auto* bars = std::get_if<Bars>(&chart.content)) {
        words << bars->nameTitle;
        for (const Bars::Bar& bar : bars->bars)
            words << bar.name;
    }
    if (const auto* histogram = std::get_if<Histogram>(&chart.content))
        limits = histogram->limits;
    for (const Limit& limit : limits)
        words << limit.name;
    return words;
}

/// Returns all texts of a widget, visible or read by a screen reader, with the kind of each.
inline QList<std::pair<QString, QString>> wordsOf(const QWidget& widget)
{
    QList<std::pair<QString, QString>> words{{"tooltip", widget.toolTip()},
                                             {"status tip", widget.statusTip()},
                                             {"accessible name", widget.accessibleName()},
                                             {"accessible description", widget.accessibleDescription()},
                                             {"window title", widget.windowTitle()}};
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        words << std::pair("text", label->text());
    if (const auto* label = qobject_cast<const ui::kit::TabularDigitsLabel*>(&widget))
        words << std::pair("text", label->text()) << std::pair("unit", label->unit());
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        words << std::pair("text", button->text());
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget))
        words << std::pair("title", box->title());
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
        words << std::pair("placeholder", line->placeholderText());
    if (const auto* number = qobject_cast<const QDoubleSpinBox*>(&widget))
        words << std::pair("unit", number->suffix()) << std::pair("prefix", number->prefix());
    if (const auto* menu = qobject_cast<const QMenu*>(&widget))
        words << std::pair("title", menu->title());
    if (const auto* progress = qobject_cast<const QProgressBar*>(&widget); progress && progress->isTextVisible())
        words << std::pair("text", progress->text());
    if (const auto* choice = qobject_cast<const QComboBox*>(&widget))
        for (int k = 0; k < choice->count(); ++k)
            words << std::pair("choice", choice->itemText(k));
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget); view != nullptr && view->model() != nullptr)
        for (int row = 0; row < view->model()->rowCount(); ++row)
            for (int column = 0; column < view->model()->columnCount(); ++column)
                for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleDescriptionRole})
                    words << std::pair("item", view->model()->index(row, column).data(role).toString());
    if (const auto* heads = qobject_cast<const QHeaderView*>(&widget); heads != nullptr && heads->model() != nullptr)
        for (int k = 0; k < heads->count(); ++k)
            for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
                words << std::pair("heading", heads->model()->headerData(k, heads->orientation(), role).toString());
    if (const auto* panel = qobject_cast<const ui::charts::ChartPanel*>(&widget))
        for (const QString& of : wordsOf(panel->chart()))
            words << std::pair("chart", of);
    for (const QAction* action : widget.actions())
        words << std::pair("action", action->text()) << std::pair("action's tooltip", action->toolTip())
              << std::pair("action's status tip", action->statusTip());
    return words;
}

/// Returns the visible texts under `root` that are in another language, because they are not translated or not updated.
/// @param fromOutside  names from files and users, which are the same in all languages
inline QStringList notTranslated(QWidget& root, const QStringList& fromOutside = {})
{
    QStringList found;
    QList<QWidget*> all = root.findChildren<QWidget*>();
    all.prepend(&root);
    for (const QWidget* widget : all) {
        if (!widget->isVisible() && qobject_cast<const QMenu*>(widget) == nullptr)
            continue;
        for (auto [what, words] : wordsOf(*widget)) {
            for (const QString& name : fromOutside)
                if (!name.isEmpty())
                    words.remove(name);
            if (const QString english = untranslated(words); !english.isEmpty())
                found << QStringLiteral("%1 %2, %3: \"%4\" in \"%5\"")
                             .arg(widget->metaObject()->className(), widget->objectName(), what, english, words);
        }
    }
    found.removeDuplicates();
    return found;
}

/// A text in a box of its own within a widget: the placeholder of a field, a heading or a cell of a table.
struct Boxed
{
    QString words;
    QString tooltip;
    int widthPx = 0;
    QFont font;
    bool wraps = false;
};

inline QList<Boxed> boxedIn(const QWidget& widget)
{
    QList<Boxed> boxes;
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) {
        constexpr int kMarginsPx = 4;
        int taken = kMarginsPx + line->textMargins().left() + line->textMargins().right();
        for (const auto* button : line->findChildren<QAbstractButton*>())
            taken += button->isVisible() ? button->width() : 0;
        const bool isNumber = qobject_cast<const QAbstractSpinBox*>(line->parentWidget()) != nullptr;
        // Typed text may have any length.
        if (isNumber || line->text().isEmpty())
            boxes << Boxed{isNumber ? line->text() : line->placeholderText(), line->toolTip(),
                           line->contentsRect().width() - taken, line->font()};
    }
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget))
        boxes << Boxed{box->title(), box->toolTip(), box->width(), box->font()};
    if (const auto* heads = qobject_cast<const QHeaderView*>(&widget);
        heads != nullptr && heads->model() != nullptr && heads->orientation() == Qt::Horizontal)
        for (int k = 0; k < heads->count(); ++k)
            if (!heads->isSectionHidden(k))
                boxes << Boxed{heads->model()->headerData(k, Qt::Horizontal).toString(),
                               heads->model()->headerData(k, Qt::Horizontal, Qt::ToolTipRole).toString(),
                               heads->sectionSize(k), heads->font(),
                               (heads->defaultAlignment().toInt() & Qt::TextWordWrap) != 0};
    if (const auto* table = qobject_cast<const QTableView*>(&widget); table != nullptr && table->model() != nullptr)
        for (int row = 0; row < table->model()->rowCount(); ++row)
            for (int column = 0; column < table->model()->columnCount(); ++column) {
                const QModelIndex index = table->model()->index(row, column);
                if (!table->isColumnHidden(column) && table->visualRect(index).isValid())
                    boxes << Boxed{index.data().toString(), index.data(Qt::ToolTipRole).toString(),
                                   table->columnWidth(column), table->font(), table->wordWrap()};
            }
    return boxes;
}

/// Returns the clipped texts of a widget that draws several.
inline QStringList clippedWithin(const QWidget& widget)
{
    QStringList found;
    for (const Boxed& box : boxedIn(widget)) {
        int widest = 0;
        for (const QString& part : box.words.split(box.wraps ? QRegularExpression(QStringLiteral("\\s+"))
                                                             : QRegularExpression(QStringLiteral("\n"))))
            widest = std::max(widest, QFontMetrics(box.font).horizontalAdvance(part));
        if (widest > box.widthPx && !box.tooltip.contains(box.words))
            found << QStringLiteral("%1 %2 '%3' has %4 px, wants %5")
                         .arg(QString::fromLatin1(widget.metaObject()->className()), widget.objectName(), box.words)
                         .arg(box.widthPx)
                         .arg(widest);
    }
    return found;
}

/// Returns the texts under `root` that have too little room or are outside. A text may be shortened only if a tooltip
/// shows all of it.
inline QStringList clipped(QWidget& root)
{
    QStringList found;
    for (QWidget* widget : root.findChildren<QWidget*>())
        if (widget->isVisible() && !widget->visibleRegion().isEmpty())
            found << clippedWithin(*widget);
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        const auto* label = qobject_cast<QLabel*>(widget);
        const auto* button = qobject_cast<QAbstractButton*>(widget);
        const bool speaks = label != nullptr || qobject_cast<ui::kit::TabularDigitsLabel*>(widget) != nullptr ||
                            button != nullptr || qobject_cast<QComboBox*>(widget) != nullptr;
        if (!widget->isVisible() || !speaks || qobject_cast<ui::toothchooser::ArchTooth*>(widget) != nullptr ||
            widget->visibleRegion().isEmpty())
            continue;
        const QString words = label != nullptr    ? label->text()
                              : button != nullptr ? button->text()
                                                  : widget->accessibleName();
        bool scrolls = false;
        for (const QWidget* holder = widget; holder != nullptr && holder != &root; holder = holder->parentWidget())
            scrolls = scrolls || qobject_cast<const QScrollArea*>(holder) != nullptr;
        const QString who =
            QStringLiteral("%1 %2 '%3'")
                .arg(QString::fromLatin1(widget->metaObject()->className()), widget->objectName(), words);
        if (!scrolls && !root.rect().contains(QRect(widget->mapTo(&root, QPoint()), widget->size())))
            found << who + QStringLiteral(" lies outside");
        if (qobject_cast<QComboBox*>(widget) != nullptr)
            continue;  // shortened, but shown in full when it is opened
        const QSize wanted =
            widget->hasHeightForWidth() ? QSize(0, widget->heightForWidth(widget->width())) : widget->sizeHint();
        if ((widget->width() < wanted.width() || widget->height() < wanted.height()) &&
            !widget->toolTip().contains(words))
            found << who + QStringLiteral(" is %1x%2, wants %3x%4")
                               .arg(widget->width())
                               .arg(widget->height())
                               .arg(wanted.width())
                               .arg(wanted.height());
    }
    return found;
}

}  // namespace pseudo
