// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QPageSize>
#include <QString>

#include "ui/report/Report.h"

class QPagedPaintDevice;
class QPrintDialog;
class QPrinter;
class QWidget;

namespace ui::report {

/// A4, or Letter where that is the paper.
[[nodiscard]] QPageSize::PageSizeId usualPaper();

/// Asks where to, beside the window's own events.
/// @param name  what the file may be called: words, made fit for a file's name
void askForPdf(QWidget* window, const QString& title, const QString& name,
               const std::function<void(const QString& path)>& chosen);

/// Writes a PDF with margins of 15 mm. False: it could not be written, and what was there before is as it was.
[[nodiscard]] bool savePdf(const QString& path, const QString& title, const scoring::ScoreCard& card,
                           QPageSize::PageSizeId paper = usualPaper());
[[nodiscard]] bool savePdf(const QString& path, const QString& title, const ClassReport& report,
                           QPageSize::PageSizeId paper = usualPaper());

/// Qt's dialog, without printing to a file. Its field for the file's name else begins at once to look about the home
/// folder, and opens what lies there; whoever closes a file that SQLite has open loses SQLite's locks on it, and
/// another program then takes its log away (https://www.sqlite.org/howtocorrupt.html, section 2.2).
[[nodiscard]] QPrintDialog* makePrintDialog(QPrinter& printer, QWidget* window);

/// Asks which printer, beside the window's own events. What is printed is made when one is chosen: paintOn() it.
/// False: there is none.
[[nodiscard]] bool askForPrinter(QWidget* window, const QString& title,
                                 const std::function<void(const std::shared_ptr<QPagedPaintDevice>& printer)>& chosen);

}  // namespace ui::report
