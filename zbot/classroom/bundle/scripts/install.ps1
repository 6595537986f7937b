# Installs zbot from this folder. `.\install.ps1 --to FOLDER` chooses the folder of the environment.
foreach ($python in "py", "python", "python3") {
    if (-not (Get-Command $python -ErrorAction SilentlyContinue)) { continue }
    & $python -c "import sys; sys.exit(sys.version_info < (3, 10))" 2>$null
    if ($LASTEXITCODE -eq 0) {
        & $python (Join-Path $PSScriptRoot "install.py") @args
        exit $LASTEXITCODE
    }
}
Write-Host "error: there is no Python 3.10 or newer: install it from python.org"
exit 1
