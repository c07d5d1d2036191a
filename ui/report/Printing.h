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

/// Returns the paper size of the locale: A4 or Letter.
[[nodiscard]] QPageSize::PageSizeId usualPaper();

/// Asks for a PDF file without blocking the window.
/// @param name  suggested file name; characters that are invalid in a file name are replaced
void askForPdf(QWidget* window, const QString& title, const QString& name,
               const std::function<void(const QString& path)>& chosen);

/// Writes a PDF with margins of 15 mm. Returns false on failure, in which case an existing file is unchanged.
[[nodiscard]] bool savePdf(const QString& path, const QString& title, const scoring::ScoreCard& card,
                           QPageSize::PageSizeId paper = usualPaper());
[[nodiscard]] bool savePdf(const QString& path, const QString& title, const ClassReport& report,
                           QPageSize::PageSizeId paper = usualPaper());

/// Returns Qt's print dialog without the option to print to a file. The file name field of that option would open the
/// files in the home folder to complete names. Closing a file that SQLite has open releases SQLite's locks on it, and
/// another program then deletes its log (https://www.sqlite.org/howtocorrupt.html, section 2.2).
[[nodiscard]] QPrintDialog* makePrintDialog(QPrinter& printer, QWidget* window);

/// Asks for a printer without blocking the window. `chosen` should print on the selected printer with paintOn().
/// Returns false if there is no printer.
[[nodiscard]] bool askForPrinter(QWidget* window, const QString& title,
                                 const std::function<void(const std::shared_ptr<QPagedPaintDevice>& printer)>& chosen);

}  // namespace ui::report
