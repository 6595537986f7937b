@echo off
rem Installs zbot from this folder. "install.cmd --to FOLDER" chooses the folder of the environment.
for %%P in (py python python3) do (
    %%P -c "import sys; sys.exit(sys.version_info < (3, 10))" >nul 2>nul && (
        %%P "%~dp0install.py" %*
        goto :end
    )
)
echo error: there is no Python 3.10 or newer: install it from python.org
exit /b 1
:end
exit /b %ERRORLEVEL%
