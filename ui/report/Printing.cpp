// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/Printing.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMarginsF>
#include <QPageLayout>
#include <QPdfWriter>
#include <QPrintDialog>
#include <QPrinter>
#include <QPrinterInfo>
#include <QSaveFile>
#include <QScopeGuard>
#include <QTemporaryDir>

#include "ui/kit/FileDialog.h"
#include "ui/kit/PrivateFile.h"
#include "ui/kit/StandardFolders.h"

namespace ui::report {
namespace {

constexpr double kMarginMm = 15.0;
constexpr int kPdfDpi = 300;

template <typename Content>
bool save(const QString& path, const QString& title, const Content& content, QPageSize::PageSizeId paper)
{
    QSaveFile file(path);
    if (!kit::openForOwner(file))
        return false;
    {
        QPdfWriter writer(&file);
        // Also stores the code in the properties of the file, where it can be copied.
        const QString& code = content.proof.auditCode;
        writer.setTitle(code.isEmpty() ? title : title + QStringLiteral(", ") + code);
        writer.setCreator(QStringLiteral("Cusp %1").arg(content.proof.program));
        writer.setResolution(kPdfDpi);
        writer.setPageSize(QPageSize(paper));
        writer.setPageMargins({kMarginMm, kMarginMm, kMarginMm, kMarginMm}, QPageLayout::Millimeter);
        if (!paintOn(writer, content))
            return false;
    }
    return file.flush() && file.commit();
}

}  // namespace

QPageSize::PageSizeId usualPaper()
{
    return QLocale::system().measurementSystem() == QLocale::ImperialUSSystem ? QPageSize::Letter : QPageSize::A4;
}

void askForPdf(QWidget* window, const QString& title, const QString& name,
               const std::function<void(const QString& path)>& chosen)
{
    auto* dialog = new kit::FileDialog(window, title, kit::documentsFolder(),
                                       QCoreApplication::translate("Printing", "PDF (*.pdf)"));
    QObject::connect(dialog, &QFileDialog::fileSelected, window, chosen);
    dialog->askWhere(name, QStringLiteral("pdf"));
}

bool savePdf(const QString& path, const QString& title, const scoring::ScoreCard& card, QPageSize::PageSizeId paper)
{
    return save(path, title, card, paper);
}

bool savePdf(const QString& path, const QString& title, const ClassReport& report, QPageSize::PageSizeId paper)
{
    return save(path, title, report, paper);
}

QPrintDialog* makePrintDialog(QPrinter& printer, QWidget* window)
{
    const QTemporaryDir empty;
    const QByteArray home = qgetenv("HOME");
    qputenv("HOME", empty.path().toLocal8Bit());
    const auto back = qScopeGuard([&home] { qputenv("HOME", home); });
    auto* dialog = new QPrintDialog(&printer, window);
    // Without printing to a file, the dialog has no button that lists other folders. Use askForPdf() to make a file.
    dialog->setOption(QAbstractPrintDialog::PrintToFile, false);
    return dialog;
}

bool askForPrinter(QWidget* window, const QString& title,
                   const std::function<void(const std::shared_ptr<QPagedPaintDevice>& printer)>& chosen)
{
    if (QPrinterInfo::availablePrinterNames().isEmpty())
        return false;
    auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setDocName(title);
    printer->setPageSize(QPageSize(usualPaper()));
    printer->setPageMargins({kMarginMm, kMarginMm, kMarginMm, kMarginMm}, QPageLayout::Millimeter);
    QPrintDialog* dialog = makePrintDialog(*printer, window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // The connection owns the printer, so it lives as long as the dialog.
    QObject::connect(dialog, &QDialog::accepted, window, [printer, chosen] { chosen(printer); });
    dialog->open();
    return true;
}

}  // namespace ui::report
