// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/SaveButton.h"

#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QMenu>
#include <QSaveFile>

#include "ui/charts/Drawing.h"
#include "ui/charts/Table.h"
#include "ui/kit/FileDialog.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/PrivateFile.h"
#include "ui/kit/StandardFolders.h"
#include "ui/text/EveryLanguage.h"

namespace ui::charts {
namespace {

using namespace ui::kit;

/// Translation context of the button's texts, shared with the panel.
struct SaveWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::charts::ChartPanel)
};

}  // namespace

Written writeChart(const Chart& chart, const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    const QByteArray bytes = ending == QLatin1String("csv")   ? csv(tableOf(chart))
                             : ending == QLatin1String("svg") ? svg(chart)
                                                              : png(chart);
    QSaveFile file(path);
    const bool isDone =
        openForOwner(file) && file.write(bytes) == bytes.size() && !bytes.isEmpty() && file.flush() && file.commit();
    const QString name = QFileInfo(path).fileName();
    return {isDone,
            isDone ? SaveWords::tr("Saved: %1").arg(name)
                   //: %2: the system's own words
                   : SaveWords::tr("%1 could not be written (%2). Try another folder.").arg(name, file.errorString())};
}

SaveButton::SaveButton(std::function<Chart()> chart, QWidget* parent) : QToolButton(parent), m_chart(std::move(chart))
{
    auto* menu = new QMenu(this);
    const auto offer = [&](const char* ending, const auto& say) {
        QAction* action = menu->addAction(QString());
        action->setObjectName(QStringLiteral("save") + QLatin1String(ending).toString().toUpper());
        text::bindTranslation(this, [action, say] { action->setText(say()); });
        connect(action, &QAction::triggered, this, [this, kind = QString::fromLatin1(ending)] { askForFile(kind); });
    };
    offer("png", [] { return SaveWords::tr("Save as picture (PNG) …"); });
    offer("svg", [] { return SaveWords::tr("Save as drawing (SVG) …"); });
    offer("csv", [] { return SaveWords::tr("Save as table (CSV) …"); });
    setMenu(menu);
    setPopupMode(QToolButton::InstantPopup);
    setObjectName(QStringLiteral("saveChart"));
    setFocusPolicy(Qt::StrongFocus);
    setIconSize({18, 18});
    setIcon(lineIcon(QStringLiteral("save"), palette()));
    text::bindTranslation(this, [this] {
        setToolTip(SaveWords::tr("Save this chart"));
        nameIt();
    });
}

void SaveButton::nameIt()
{
    setAccessibleName(SaveWords::tr("Save the chart \"%1\"").arg(m_chart().title));
}

void SaveButton::beSmall()
{
    setStyleSheet(QStringLiteral("QToolButton { padding: 3px; } QToolButton:focus { padding: 2px; }"
                                 "QToolButton::menu-indicator { image: none; width: 0px; }"));
}

void SaveButton::changeEvent(QEvent* event)
{
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        setIcon(lineIcon(QStringLiteral("save"), palette()));
}

void SaveButton::askForFile(const QString& ending)
{
    const Chart chart = m_chart();
    auto* dialog = new FileDialog(parentWidget(), SaveWords::tr("Save the chart"), documentsFolder(),
                                  QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending));
    connect(dialog, &QFileDialog::fileSelected, this, &SaveButton::save);
    dialog->askWhere(chart.of.isEmpty() ? chart.title : QStringLiteral("%1, %2").arg(chart.title, chart.of), ending);
}

bool SaveButton::save(const QString& path)
{
    const Written written = writeChart(m_chart(), path);
    emit told(written.told);
    return written.isDone;
}

}  // namespace ui::charts
