<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>&amp;Copy versions for a bug report</source>
        <translation>&amp;Kopiuj wersje do zgłoszenia błędu</translation>
    </message>
    <message>
        <source>&amp;Open that folder</source>
        <translation>&amp;Otwórz ten folder</translation>
    </message>
    <message>
        <source>A planning aid, not for navigation. It knows land, the forecast and the yacht&apos;s polar; it does not know shoals, traffic schemes, local rules or your crew.</source>
        <translation>Narzędzie do planowania, nie do nawigacji. Program zna ląd, prognozę i biegunową jachtu; nie zna płycizn, systemów rozgraniczenia ruchu, przepisów lokalnych ani twojej załogi.</translation>
    </message>
    <message>
        <source>About SeaCruise</source>
        <translation>O programie SeaCruise</translation>
    </message>
    <message>
        <source>Copied: versions of SeaCruise, Python, Qt and the system.</source>
        <translation>Skopiowano: wersje SeaCruise, Pythona, Qt i systemu.</translation>
    </message>
    <message>
        <source>How long will the cruise take under sail, and is a week enough?</source>
        <translation>Jak długo potrwa rejs pod żaglami i czy wystarczy tydzień?</translation>
    </message>
    <message>
        <source>Sources and licences</source>
        <translation>Źródła i licencje</translation>
    </message>
    <message>
        <source>Your files and seacruise.log: {folder}</source>
        <translation>Twoje pliki i seacruise.log: {folder}</translation>
    </message>
</context>
<context>
    <name>Avoided</name>
    <message>
        <source>avoiding an area</source>
        <translation>omijanie obszaru</translation>
    </message>
    <message>
        <source>opening an area</source>
        <translation>otwarcie obszaru</translation>
    </message>
    <message>
        <source>{radius:g} nm to avoid</source>
        <translation>omijane: {radius:g} Mm</translation>
    </message>
</context>
<context>
    <name>ChartPane</name>
    <message>
        <source>Measure distance and bearing (Ctrl+M)</source>
        <translation>Zmierz odległość i namiar (Ctrl+M)</translation>
    </message>
    <message>
        <source>Show the whole passage</source>
        <translation>Pokaż całą trasę</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Przybliż</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Oddal</translation>
    </message>
</context>
<context>
    <name>ChartView</name>
    <message>
        <source>Chart</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move the chart, the menu key offers what can be done in its middle; the legs table says the same in words.</source>
        <translation>Plus i minus przybliżają i oddalają, strzałki przesuwają mapę, klawisz menu pokazuje, co można zrobić w jej środku; tabela odcinków mówi to samo słowami.</translation>
    </message>
</context>
<context>
    <name>Columns</name>
    <message>
        <source>To the answer (F7)</source>
        <translation>Do odpowiedzi (F7)</translation>
    </message>
    <message>
        <source>To the question (F6)</source>
        <translation>Do pytania (F6)</translation>
    </message>
    <message>
        <source>What is ans&amp;wered</source>
        <translation>Od&amp;powiedź</translation>
    </message>
    <message>
        <source>What is as&amp;ked</source>
        <translation>P&amp;ytanie</translation>
    </message>
</context>
<context>
    <name>DaylightStrip</name>
    <message>
        <source>{share:.0%} of the passage is dark</source>
        <translation>{share:.0%} trasy w ciemności</translation>
    </message>
</context>
<context>
    <name>DepartureCurve</name>
    <message>
        <source>Curve over the departures; the table beside it says the same</source>
        <translation>Krzywa po wyjściach; tabela obok mówi to samo</translation>
    </message>
    <message>
        <source>shortest</source>
        <translation>najkrócej</translation>
    </message>
    <message>
        <source>{h:g} h</source>
        <translation>{h:g} h</translation>
    </message>
</context>
<context>
    <name>DepartureField</name>
    <message>
        <source>Choose the date of departure in a calendar</source>
        <translation>Wybierz datę wyjścia w kalendarzu</translation>
    </message>
    <message>
        <source>Date of departure</source>
        <translation>Data wyjścia</translation>
    </message>
    <message>
        <source>Days that the forecast covers</source>
        <translation>Dni, które obejmuje prognoza</translation>
    </message>
    <message>
        <source>Not in the forecast, which covers {range}.</source>
        <translation>Poza prognozą, która obejmuje okres {range}.</translation>
    </message>
    <message>
        <source>The departure on {moment} is not within the forecast, which covers {range}.</source>
        <translation>Wyjście {moment} nie mieści się w prognozie, która obejmuje okres {range}.</translation>
    </message>
    <message>
        <source>Time of departure</source>
        <translation>Godzina wyjścia</translation>
    </message>
    <message>
        <source>{first} to {last}</source>
        <translation>od {first} do {last}</translation>
    </message>
    <message>
        <source>{zone}. The forecast covers {range}.</source>
        <translation>{zone}. Prognoza obejmuje okres {range}.</translation>
    </message>
</context>
<context>
    <name>DeparturesPage</name>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>A column for each yacht, in place of every figure of each passage</source>
        <translation>Kolumna dla każdego jachtu zamiast wszystkich liczb każdej trasy</translation>
    </message>
    <message>
        <source>Another yacht</source>
        <translation>Inny jacht</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Przybycie</translation>
    </message>
    <message>
        <source>By yacht</source>
        <translation>Według jachtu</translation>
    </message>
    <message>
        <source>Choose a departure in the curve or in the table.</source>
        <translation>Wybierz wyjście na krzywej albo w tabeli.</translation>
    </message>
    <message>
        <source>Compare another yacht too</source>
        <translation>Porównaj też inny jacht</translation>
    </message>
    <message>
        <source>Compared is the direct passage, not by way of {via}.</source>
        <translation>Porównywana jest trasa bezpośrednia, nie przez {via}.</translation>
    </message>
    <message>
        <source>Depart&amp;ures</source>
        <translation>Liczb&amp;a wyjść</translation>
    </message>
    <message>
        <source>Departures compared</source>
        <translation>Porównane wyjścia</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Czas trwania</translation>
    </message>
    <message>
        <source>Ensemble</source>
        <translation>Wiązka</translation>
    </message>
    <message>
        <source>Hours between departures</source>
        <translation>Godziny między wyjściami</translation>
    </message>
    <message>
        <source>Hours under way over the departure</source>
        <translation>Godziny w drodze w zależności od wyjścia</translation>
    </message>
    <message>
        <source>Leave then</source>
        <translation>Wyjdź wtedy</translation>
    </message>
    <message>
        <source>Leave {yacht} out</source>
        <translation>Pomiń {yacht}</translation>
    </message>
    <message>
        <source>Moment of arrival over the departure</source>
        <translation>Chwila przybycia w zależności od wyjścia</translation>
    </message>
    <message>
        <source>Number of departures</source>
        <translation>Liczba wyjść</translation>
    </message>
    <message>
        <source>Of the {n} that were compared: {said}</source>
        <translation>Z porównanych ({n}): {said}</translation>
    </message>
    <message>
        <source>Plan for each member too, where the forecast has members: the band behind the curve</source>
        <translation>Planuj też dla każdego członu, jeśli prognoza je ma: pasmo za krzywą</translation>
    </message>
    <message>
        <source>So far: {said}</source>
        <translation>Dotąd: {said}</translation>
    </message>
    <message>
        <source>Take this departure for the passage (Enter)</source>
        <translation>Przyjmij to wyjście dla trasy (Enter)</translation>
    </message>
    <message>
        <source>eve&amp;ry</source>
        <translation>&amp;co</translation>
    </message>
    <message>
        <source>{leaves}: not known yet.</source>
        <translation>{leaves}: jeszcze nieznane.</translation>
    </message>
</context>
<context>
    <name>Desk</name>
    <message>
        <source>Saved as “{name}”.</source>
        <translation>Zapisano jako „{name}”.</translation>
    </message>
    <message>
        <source>Saved passages</source>
        <translation>Zapisane trasy</translation>
    </message>
    <message>
        <source>Weather</source>
        <translation>Pogoda</translation>
    </message>
    <message>
        <source>Yachts</source>
        <translation>Jachty</translation>
    </message>
</context>
<context>
    <name>Exporter</name>
    <message>
        <source>GPX route (*.gpx)</source>
        <translation>Trasa GPX (*.gpx)</translation>
    </message>
    <message>
        <source>GeoJSON (*.geojson)</source>
        <translation>GeoJSON (*.geojson)</translation>
    </message>
    <message>
        <source>KML for Google Earth (*.kml)</source>
        <translation>KML dla Google Earth (*.kml)</translation>
    </message>
    <message>
        <source>Passage plan (*.pdf)</source>
        <translation>Plan trasy (*.pdf)</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Obraz (*.png)</translation>
    </message>
    <message>
        <source>Save the passage</source>
        <translation>Zapisz trasę</translation>
    </message>
    <message>
        <source>Table of legs (*.csv)</source>
        <translation>Tabela odcinków (*.csv)</translation>
    </message>
</context>
<context>
    <name>FitPanel</name>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Odrzuć</translation>
    </message>
    <message>
        <source>Fitting a polar to your log</source>
        <translation>Dopasowanie biegunowej do twojego dziennika</translation>
    </message>
    <message>
        <source>Keep her</source>
        <translation>Zachowaj</translation>
    </message>
    <message>
        <source>Progress of the fit</source>
        <translation>Postęp dopasowania</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wczytywanie…</translation>
    </message>
    <message>
        <source>Save the polar in your own folder; the next log learns on</source>
        <translation>Zapisz biegunową we własnym folderze; następny dziennik uczy ją dalej</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
</context>
<context>
    <name>FleetList</name>
    <message>
        <source>Search the fleet</source>
        <translation>Szukaj we flocie</translation>
    </message>
    <message>
        <source>Yachts</source>
        <translation>Jachty</translation>
    </message>
</context>
<context>
    <name>ForecastBox</name>
    <message>
        <source>Automatic</source>
        <translation>Automatycznie</translation>
    </message>
    <message>
        <source>Forecast files</source>
        <translation>Pliki prognozy</translation>
    </message>
    <message>
        <source>GRIB or NetCDF file…</source>
        <translation>Plik GRIB lub NetCDF…</translation>
    </message>
    <message>
        <source>MET Norway</source>
        <translation>MET Norway</translation>
    </message>
    <message>
        <source>Open-Meteo</source>
        <translation>Open-Meteo</translation>
    </message>
    <message>
        <source>Open-Meteo ensemble</source>
        <translation>Open-Meteo, wiązka</translation>
    </message>
    <message>
        <source>Practice weather (not a forecast)</source>
        <translation>Pogoda ćwiczebna (to nie prognoza)</translation>
    </message>
    <message>
        <source>Sample: 20–22 November 2016</source>
        <translation>Przykład: 20–22 listopada 2016</translation>
    </message>
    <message>
        <source>Storm Glass (needs a key)</source>
        <translation>Storm Glass (wymaga klucza)</translation>
    </message>
</context>
<context>
    <name>Guide</name>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Gotowe</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Przewodnik</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Pomiń</translation>
    </message>
    <message>
        <source>{n} of {all}</source>
        <translation>{n} z {all}</translation>
    </message>
</context>
<context>
    <name>Habits</name>
    <message>
        <source>&amp;Guide in three steps</source>
        <translation>&amp;Przewodnik w trzech krokach</translation>
    </message>
    <message>
        <source>Calculate, then drag</source>
        <translation>Oblicz, potem przeciągaj</translation>
    </message>
    <message>
        <source>Choose the departure, your yacht and the forecast. Without a key and without a network there is practice weather, to try things out.</source>
        <translation>Wybierz termin wyjścia, swój jacht i prognozę. Bez klucza i bez sieci jest pogoda ćwiczebna, do wypróbowania programu.</translation>
    </message>
    <message>
        <source>Press Calculate or Ctrl+Enter. Then drag the departure below the chart, or the start or the end: the passage follows at once.</source>
        <translation>Naciśnij Oblicz albo Ctrl+Enter. Potem przeciągnij wyjście pod mapą, start albo cel: trasa zmienia się od razu.</translation>
    </message>
    <message>
        <source>Type the beginning of a port&apos;s name, or a position such as 54.5, 18.6. Or right-click on the chart: sail from here, to here.</source>
        <translation>Wpisz początek nazwy portu albo pozycję, np. 54.5, 18.6. Albo kliknij mapę prawym przyciskiem: płyń stąd, płyń tutaj.</translation>
    </message>
    <message>
        <source>When, and with which yacht</source>
        <translation>Kiedy i którym jachtem</translation>
    </message>
    <message>
        <source>Where from, where to</source>
        <translation>Skąd i dokąd</translation>
    </message>
</context>
<context>
    <name>KeyBox</name>
    <message>
        <source>Asking Storm Glass…</source>
        <translation>Pytanie do Storm Glass…</translation>
    </message>
    <message>
        <source>It is kept until SeaCruise closes: this system has no keychain that it can use.</source>
        <translation>Pozostanie tylko do zamknięcia SeaCruise: ten system nie udostępnia pęku kluczy.</translation>
    </message>
    <message>
        <source>Keep the key</source>
        <translation>Zachowaj klucz</translation>
    </message>
    <message>
        <source>Keeping the key…</source>
        <translation>Zapisywanie klucza…</translation>
    </message>
    <message>
        <source>Key {shown} is from STORMGLASS_API_KEY, which comes before any other.</source>
        <translation>Klucz {shown} pochodzi z STORMGLASS_API_KEY, który ma pierwszeństwo.</translation>
    </message>
    <message>
        <source>Key {shown} is kept in the system&apos;s keychain.</source>
        <translation>Klucz {shown} jest w systemowym pęku kluczy.</translation>
    </message>
    <message>
        <source>Key {shown}. {lasting}</source>
        <translation>Klucz {shown}. {lasting}</translation>
    </message>
    <message>
        <source>No key yet; a free one allows ten requests a day. {lasting}</source>
        <translation>Nie ma jeszcze klucza; bezpłatny pozwala na dziesięć zapytań dziennie. {lasting}</translation>
    </message>
    <message>
        <source>Paste another key here</source>
        <translation>Wklej tu inny klucz</translation>
    </message>
    <message>
        <source>Paste your key here</source>
        <translation>Wklej tu swój klucz</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Usuń go</translation>
    </message>
    <message>
        <source>Removing the key…</source>
        <translation>Usuwanie klucza…</translation>
    </message>
    <message>
        <source>Storm Glass accepts the key: {left} of {daily} requests left today.</source>
        <translation>Storm Glass przyjmuje klucz: na dziś zostało {left} z {daily} zapytań.</translation>
    </message>
    <message>
        <source>Storm Glass does not accept this key; copy it again from your page there.</source>
        <translation>Storm Glass nie przyjmuje tego klucza; skopiuj go jeszcze raz ze swojej strony w serwisie.</translation>
    </message>
    <message>
        <source>Storm Glass key</source>
        <translation>Klucz Storm Glass</translation>
    </message>
    <message>
        <source>Test it (one request)</source>
        <translation>Sprawdź go (jedno zapytanie)</translation>
    </message>
    <message>
        <source>The system&apos;s keychain will keep it.</source>
        <translation>Zachowa go systemowy pęk kluczy.</translation>
    </message>
</context>
<context>
    <name>LegsTable</name>
    <message>
        <source>Legs of the passage</source>
        <translation>Odcinki trasy</translation>
    </message>
</context>
<context>
    <name>LogTable</name>
    <message>
        <source>Log of the passage</source>
        <translation>Dziennik żeglugi</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Cancelled</source>
        <translation>Anulowano</translation>
    </message>
    <message>
        <source>Loading ports, yachts and the forecast…</source>
        <translation>Wczytywanie portów, jachtów i prognozy…</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>Saved {path}</source>
        <translation>Zapisano {path}</translation>
    </message>
    <message>
        <source>Some polars cannot be used</source>
        <translation>Niektórych biegunowych nie można użyć</translation>
    </message>
    <message>
        <source>The passage is calculated as soon as they are there.</source>
        <translation>Trasa zostanie obliczona, gdy tylko się wczytają.</translation>
    </message>
    <message>
        <source>{yacht} is in your fleet now.</source>
        <translation>{yacht} jest teraz w twojej flocie.</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;About SeaCruise</source>
        <translation>&amp;O programie SeaCruise</translation>
    </message>
    <message>
        <source>&amp;Angle to the wind (TWA)</source>
        <translation>&amp;Kąt do wiatru (TWA)</translation>
    </message>
    <message>
        <source>&amp;Boat speed</source>
        <translation>Prędkość &amp;jachtu</translation>
    </message>
    <message>
        <source>&amp;Calculate</source>
        <translation>&amp;Oblicz</translation>
    </message>
    <message>
        <source>&amp;Colour the route by</source>
        <translation>&amp;Koloruj trasę według</translation>
    </message>
    <message>
        <source>&amp;Day</source>
        <translation>&amp;Dzień</translation>
    </message>
    <message>
        <source>&amp;Depth tint</source>
        <translation>Barwy &amp;głębokości</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edycja</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>P&amp;lik</translation>
    </message>
    <message>
        <source>&amp;Follow changes at once</source>
        <translation>&amp;Uwzględniaj zmiany od razu</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Po&amp;moc</translation>
    </message>
    <message>
        <source>&amp;How she is sailed…</source>
        <translation>&amp;Sposób żeglugi…</translation>
    </message>
    <message>
        <source>&amp;Jump to</source>
        <translation>Prz&amp;ejdź do</translation>
    </message>
    <message>
        <source>&amp;Lattice</source>
        <translation>&amp;Siatka obliczeń</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>Po&amp;miar</translation>
    </message>
    <message>
        <source>&amp;Night</source>
        <translation>&amp;Noc</translation>
    </message>
    <message>
        <source>&amp;Passage</source>
        <translation>&amp;Trasa</translation>
    </message>
    <message>
        <source>&amp;Point of sail</source>
        <translation>K&amp;urs względem wiatru</translation>
    </message>
    <message>
        <source>&amp;Ports</source>
        <translation>&amp;Porty</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Zakończ</translation>
    </message>
    <message>
        <source>&amp;Recent passages</source>
        <translation>Ost&amp;atnie trasy</translation>
    </message>
    <message>
        <source>&amp;Swap start and end</source>
        <translation>&amp;Zamień start i cel</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Jednostki</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Widok</translation>
    </message>
    <message>
        <source>&amp;Weather…</source>
        <translation>&amp;Pogoda…</translation>
    </message>
    <message>
        <source>&amp;Wind barbs</source>
        <translation>Chorągiewki &amp;wiatru</translation>
    </message>
    <message>
        <source>&amp;Wind speed (TWS)</source>
        <translation>Prędkość &amp;wiatru (TWS)</translation>
    </message>
    <message>
        <source>&amp;Yachts…</source>
        <translation>Jach&amp;ty…</translation>
    </message>
    <message>
        <source>&amp;Zones to keep out of</source>
        <translation>Stre&amp;fy zakazane</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>&amp;Anuluj</translation>
    </message>
    <message>
        <source>Choose Open-Meteo&apos;s ensemble, or a file with members, as the forecast.</source>
        <translation>Wybierz jako prognozę wiązkę Open-Meteo albo plik z członami.</translation>
    </message>
    <message>
        <source>D&amp;usk</source>
        <translation>&amp;Zmierzch</translation>
    </message>
    <message>
        <source>Day and &amp;night</source>
        <translation>Dzień i no&amp;c</translation>
    </message>
    <message>
        <source>Fewer &amp;turns</source>
        <translation>M&amp;niej zwrotów</translation>
    </message>
    <message>
        <source>L&amp;egs, weather, log</source>
        <translation>&amp;Odcinki, pogoda, dziennik</translation>
    </message>
    <message>
        <source>Langu&amp;age</source>
        <translation>Jęz&amp;yk</translation>
    </message>
    <message>
        <source>Li&amp;ght</source>
        <translation>Oświet&amp;lenie</translation>
    </message>
    <message>
        <source>Lines of e&amp;qual time</source>
        <translation>Linie &amp;równego czasu</translation>
    </message>
    <message>
        <source>Members of t&amp;he forecast</source>
        <translation>C&amp;złony prognozy</translation>
    </message>
    <message>
        <source>Members of t&amp;he forecast (it has none)</source>
        <translation>C&amp;złony prognozy (nie ma ich)</translation>
    </message>
    <message>
        <source>Othe&amp;r ways</source>
        <translation>&amp;Inne drogi</translation>
    </message>
    <message>
        <source>Sa&amp;ve this passage</source>
        <translation>Zapisz tę t&amp;rasę</translation>
    </message>
    <message>
        <source>Sail another wa&amp;y</source>
        <translation>Płyń &amp;inną drogą</translation>
    </message>
    <message>
        <source>Save as &amp;KML…</source>
        <translation>Zapisz jako &amp;KML…</translation>
    </message>
    <message>
        <source>Save as Geo&amp;JSON…</source>
        <translation>Zapisz jako Geo&amp;JSON…</translation>
    </message>
    <message>
        <source>Save chart as &amp;PNG…</source>
        <translation>Zapisz mapę jako P&amp;NG…</translation>
    </message>
    <message>
        <source>Save legs as &amp;CSV…</source>
        <translation>Zapisz odcinki jako &amp;CSV…</translation>
    </message>
    <message>
        <source>Save passage plan as P&amp;DF…</source>
        <translation>Zapisz plan trasy jako P&amp;DF…</translation>
    </message>
    <message>
        <source>Save route as &amp;GPX…</source>
        <translation>Zapisz trasę jako &amp;GPX…</translation>
    </message>
    <message>
        <source>Saved p&amp;assages…</source>
        <translation>Zapisane tra&amp;sy…</translation>
    </message>
    <message>
        <source>Whole pa&amp;ssage</source>
        <translation>C&amp;ała trasa</translation>
    </message>
    <message>
        <source>Wind as &amp;field of colour</source>
        <translation>Wia&amp;tr jako barwne pole</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Przy&amp;bliż</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>O&amp;ddal</translation>
    </message>
</context>
<context>
    <name>Meteogram</name>
    <message>
        <source>Weather along the passage</source>
        <translation>Pogoda na trasie</translation>
    </message>
</context>
<context>
    <name>NumberBox</name>
    <message>
        <source>kn</source>
        <translation>kn</translation>
    </message>
</context>
<context>
    <name>OptionsBar</name>
    <message>
        <source>Crew sails at</source>
        <translation>Załoga płynie na</translation>
    </message>
    <message>
        <source>Crew, wind limit, engine…</source>
        <translation>Załoga, wiatr, silnik…</translation>
    </message>
    <message>
        <source>Everything about how she is sailed (Ctrl+Shift+O)</source>
        <translation>Wszystkie ustawienia żeglugi (Ctrl+Shift+O)</translation>
    </message>
    <message>
        <source>Fewer options</source>
        <translation>Mniej opcji</translation>
    </message>
    <message>
        <source>Limits, &amp;boards, search…</source>
        <translation>O&amp;graniczenia, halsy…</translation>
    </message>
    <message>
        <source>What differs from the defaults</source>
        <translation>Co różni się od ustawień domyślnych</translation>
    </message>
</context>
<context>
    <name>OptionsDialog</name>
    <message>
        <source> % a metre</source>
        <translation> % na metr</translation>
    </message>
    <message>
        <source> % of polar</source>
        <translation> % biegunowej</translation>
    </message>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source> kn</source>
        <translation> kn</translation>
    </message>
    <message>
        <source> l/h</source>
        <translation> l/h</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>1.5 h</source>
        <translation>1,5 h</translation>
    </message>
    <message>
        <source>A gybe costs</source>
        <translation>Zwrot przez rufę kosztuje</translation>
    </message>
    <message>
        <source>A tack costs</source>
        <translation>Zwrot przez sztag kosztuje</translation>
    </message>
    <message>
        <source>After the forecast</source>
        <translation>Po końcu prognozy</translation>
    </message>
    <message>
        <source>Back to &amp;defaults</source>
        <translation>Ustawienia &amp;domyślne</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Halsy</translation>
    </message>
    <message>
        <source>Counts where the forecast has it</source>
        <translation>Liczy się, jeśli prognoza to zawiera</translation>
    </message>
    <message>
        <source>Crew sails at</source>
        <translation>Załoga płynie na</translation>
    </message>
    <message>
        <source>Differs from the defaults: {what}.</source>
        <translation>Inne niż domyślne: {what}.</translation>
    </message>
    <message>
        <source>Distance from the shore</source>
        <translation>Odległość od brzegu</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Silnik</translation>
    </message>
    <message>
        <source>Everything is at its default.</source>
        <translation>Wszystkie ustawienia są domyślne.</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Paliwo</translation>
    </message>
    <message>
        <source>Highest waves</source>
        <translation>Najwyższe fale</translation>
    </message>
    <message>
        <source>How it is searched</source>
        <translation>Sposób szukania</translation>
    </message>
    <message>
        <source>How she is sailed</source>
        <translation>Sposób żeglugi</translation>
    </message>
    <message>
        <source>Kept everywhere but on the way out of and into the ports</source>
        <translation>Zachowana wszędzie poza wyjściem z portu i podejściem do portu</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Ograniczenia</translation>
    </message>
    <message>
        <source>May leave later by</source>
        <translation>Może wyjść później o</translation>
    </message>
    <message>
        <source>Most wind (TWS)</source>
        <translation>Najsilniejszy wiatr (TWS)</translation>
    </message>
    <message>
        <source>Motor when slower than</source>
        <translation>Silnik poniżej</translation>
    </message>
    <message>
        <source>Reckon with the current</source>
        <translation>Uwzględniaj prąd</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Szukanie</translation>
    </message>
    <message>
        <source>She waits where that brings her there earlier, or at all</source>
        <translation>Jacht czeka, jeśli dzięki temu dotrze wcześniej albo w ogóle</translation>
    </message>
    <message>
        <source>Slower by waves</source>
        <translation>Wolniej na fali</translation>
    </message>
    <message>
        <source>Speed under engine</source>
        <translation>Prędkość na silniku</translation>
    </message>
    <message>
        <source>Strongest gusts</source>
        <translation>Najsilniejsze porywy</translation>
    </message>
    <message>
        <source>Tack up and gybe down the wind</source>
        <translation>Halsowanie pod wiatr i z wiatrem</translation>
    </message>
    <message>
        <source>Tacks and gybes at most</source>
        <translation>Najwyżej zwrotów</translation>
    </message>
    <message>
        <source>The forecast at hand has no current.</source>
        <translation>Ta prognoza nie zawiera prądu.</translation>
    </message>
    <message>
        <source>Usual length of a board</source>
        <translation>Zwykła długość halsu</translation>
    </message>
    <message>
        <source>What differs from the defaults</source>
        <translation>Co różni się od ustawień domyślnych</translation>
    </message>
    <message>
        <source>What each metre of waves above half a metre takes off her speed head to sea, where the forecast has waves; 8 % is a rule of thumb</source>
        <translation>Ile prędkości pod falę odbiera każdy metr fali powyżej pół metra, jeśli prognoza zawiera fale; z grubsza 8 %</translation>
    </message>
    <message>
        <source>Yacht and crew</source>
        <translation>Jacht i załoga</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>ile trzeba</translation>
    </message>
    <message>
        <source>classic (the 2016 method)</source>
        <translation>klasyczne (metoda z 2016 r.)</translation>
    </message>
    <message>
        <source>hold the last wind</source>
        <translation>utrzymaj ostatni wiatr</translation>
    </message>
    <message>
        <source>let the wind fade</source>
        <translation>wygaszaj wiatr</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nigdy</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>bez ograniczenia</translation>
    </message>
    <message>
        <source>none kept</source>
        <translation>dowolna</translation>
    </message>
    <message>
        <source>of that at night</source>
        <translation>z tego w nocy</translation>
    </message>
    <message>
        <source>precise</source>
        <translation>dokładne</translation>
    </message>
    <message>
        <source>refuse to sail on</source>
        <translation>nie płyń dalej</translation>
    </message>
</context>
<context>
    <name>PagesFrame</name>
    <message>
        <source>Close the pages</source>
        <translation>Zamknij strony</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Strony</translation>
    </message>
</context>
<context>
    <name>PassageForm</name>
    <message>
        <source>&amp;Calculate</source>
        <translation>&amp;Oblicz</translation>
    </message>
    <message>
        <source>&amp;Departure</source>
        <translation>Wyjśc&amp;ie</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;Dokąd</translation>
    </message>
    <message>
        <source>&amp;Yacht</source>
        <translation>&amp;Jacht</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Ctrl+Enter</source>
        <translation>Ctrl+Enter</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>F&amp;orecast</source>
        <translation>Pro&amp;gnoza</translation>
    </message>
    <message>
        <source>Fro&amp;m</source>
        <translation>&amp;Skąd</translation>
    </message>
    <message>
        <source>Loading the yachts…</source>
        <translation>Wczytywanie jachtów…</translation>
    </message>
    <message>
        <source>Passage</source>
        <translation>Trasa</translation>
    </message>
    <message>
        <source>Port, or 54.5, 18.6</source>
        <translation>Port albo 54.5, 18.6</translation>
    </message>
    <message>
        <source>Port, or 59.3, 18.1</source>
        <translation>Port albo 59.3, 18.1</translation>
    </message>
    <message>
        <source>Swap start and end</source>
        <translation>Zamień start i cel</translation>
    </message>
    <message>
        <source>There is no yacht yet; wait until they are loaded, or drop a polar file on the window.</source>
        <translation>Nie ma jeszcze jachtów; poczekaj, aż się wczytają, albo upuść plik biegunowej na okno.</translation>
    </message>
</context>
<context>
    <name>PassagePane</name>
    <message>
        <source>Courses to steer, one row a leg (Alt+1)</source>
        <translation>Kursy do sterowania, odcinek po odcinku (Alt+1)</translation>
    </message>
    <message>
        <source>Fold the pages away</source>
        <translation>Zwiń panel</translation>
    </message>
    <message>
        <source>L&amp;egs of the passage</source>
        <translation>Odci&amp;nki trasy</translation>
    </message>
    <message>
        <source>L&amp;og of the passage</source>
        <translation>Dziennik żegl&amp;ugi</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Odcinki</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Dziennik</translation>
    </message>
    <message>
        <source>Once there is a passage: each leg with its time, course, distance, wind and sail. Choosing a leg shows it on the chart.</source>
        <translation>Gdy jest trasa: każdy odcinek z czasem, kursem, odległością, wiatrem i żaglem. Wybrany odcinek widać na mapie.</translation>
    </message>
    <message>
        <source>Once there is a passage: what you would write into the log, from leaving port to arriving: headlands, tacks, changes of the wind, sunrise and sunset.</source>
        <translation>Gdy jest trasa: to, co zapisuje się w dzienniku od wyjścia z portu do przybycia: przylądki, zwroty, zmiany wiatru, wschód i zachód słońca.</translation>
    </message>
    <message>
        <source>Once there is a passage: wind, gusts, angle to the wind and boat speed hour by hour, with the nights and the end of the forecast.</source>
        <translation>Gdy jest trasa: wiatr, porywy, kąt do wiatru i prędkość jachtu godzina po godzinie, z nocami i końcem prognozy.</translation>
    </message>
    <message>
        <source>Show the pages</source>
        <translation>Pokaż panel</translation>
    </message>
    <message>
        <source>The passage told in sentences (Alt+3)</source>
        <translation>Trasa opisana słowami (Alt+3)</translation>
    </message>
    <message>
        <source>We&amp;ather along the way</source>
        <translation>Pogoda po drodz&amp;e</translation>
    </message>
    <message>
        <source>Weather along the way</source>
        <translation>Pogoda po drodze</translation>
    </message>
    <message>
        <source>What is shown of the passage</source>
        <translation>Co pokazać o trasie</translation>
    </message>
    <message>
        <source>Wind, boat speed and sea over time (Alt+2)</source>
        <translation>Wiatr, prędkość jachtu i morze w czasie (Alt+2)</translation>
    </message>
</context>
<context>
    <name>PassagesPage</name>
    <message numerus="yes">
        <source>%n passage(s) deleted.</source>
        <translation>
            <numerusform>Usunięto %n trasę.</numerusform>
            <numerusform>Usunięto %n trasy.</numerusform>
            <numerusform>Usunięto %n tras.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Usuń</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Otwó&amp;rz</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>Zmień &amp;nazwę…</translation>
    </message>
    <message>
        <source>&amp;Save the passage on the chart</source>
        <translation>&amp;Zapisz trasę z mapy</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Damaged and left out: {names}.</source>
        <translation>Uszkodzone i pominięte: {names}.</translation>
    </message>
    <message>
        <source>Del; Ctrl+Z brings it back</source>
        <translation>Del; Ctrl+Z przywraca</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>Usuń je</translation>
    </message>
    <message>
        <source>It is gone for good: deleted passages are kept for a day.</source>
        <translation>Trasy nie da się już odzyskać: usunięte trasy są przechowywane przez dobę.</translation>
    </message>
    <message>
        <source>Name of the passage</source>
        <translation>Nazwa trasy</translation>
    </message>
    <message>
        <source>No passage is saved yet. Plan one, then save it: it will open again as it was.</source>
        <translation>Nie zapisano jeszcze żadnej trasy. Zaplanuj ją i zapisz: otworzy się ponownie taka, jaka była.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Zmień nazwę</translation>
    </message>
    <message>
        <source>Saved passages</source>
        <translation>Zapisane trasy</translation>
    </message>
    <message>
        <source>The damaged passages are deleted.</source>
        <translation>Uszkodzone trasy usunięto.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Cofnij</translation>
    </message>
    <message>
        <source>“{name}” is deleted.</source>
        <translation>Usunięto „{name}”.</translation>
    </message>
</context>
<context>
    <name>Planning</name>
    <message>
        <source>When to &amp;go</source>
        <translation>&amp;Kiedy wyjść</translation>
    </message>
    <message>
        <source>When to go</source>
        <translation>Kiedy wyjść</translation>
    </message>
    <message>
        <source>Where to g&amp;o</source>
        <translation>&amp;Dokąd płynąć</translation>
    </message>
    <message>
        <source>Where to go</source>
        <translation>Dokąd płynąć</translation>
    </message>
</context>
<context>
    <name>PolarDiagram</name>
    <message>
        <source>Polar diagram</source>
        <translation>Wykres biegunowy</translation>
    </message>
</context>
<context>
    <name>ProgressPanel</name>
    <message>
        <source>Calculating</source>
        <translation>Obliczanie</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Postęp</translation>
    </message>
    <message>
        <source>Refining it</source>
        <translation>Wygładzanie</translation>
    </message>
    <message>
        <source>Sailing it again, to check</source>
        <translation>Sprawdzanie odcinek po odcinku</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Rozpoczynanie…</translation>
    </message>
    <message>
        <source>The fastest passage</source>
        <translation>Najszybsza trasa</translation>
    </message>
    <message>
        <source>The lattice of courses</source>
        <translation>Siatka kursów</translation>
    </message>
    <message>
        <source>The sea between the ports</source>
        <translation>Morze między portami</translation>
    </message>
    <message>
        <source>The wind</source>
        <translation>Wiatr</translation>
    </message>
    <message>
        <source>{n:.1f} s</source>
        <translation>{n:.1f} s</translation>
    </message>
</context>
<context>
    <name>ReachPage</name>
    <message>
        <source> h</source>
        <translation> h</translation>
    </message>
    <message>
        <source>&amp;stay</source>
        <translation>&amp;postój</translation>
    </message>
    <message>
        <source>Filter by name or country</source>
        <translation>Filtruj po nazwie lub kraju</translation>
    </message>
    <message>
        <source>Filter ports by name or country</source>
        <translation>Filtruj porty po nazwie lub kraju</translation>
    </message>
    <message>
        <source>Hours or days</source>
        <translation>Godziny lub dni</translation>
    </message>
    <message>
        <source>Make this port the destination and calculate (Enter)</source>
        <translation>Ustaw ten port jako cel i oblicz (Enter)</translation>
    </message>
    <message>
        <source>No port like that; clear the filter.</source>
        <translation>Nie ma takiego portu; wyczyść filtr.</translation>
    </message>
    <message>
        <source>Only what fits</source>
        <translation>Tylko to, co się mieści</translation>
    </message>
    <message>
        <source>Plan to it</source>
        <translation>Planuj trasę tam</translation>
    </message>
    <message>
        <source>Ports in reach</source>
        <translation>Porty w zasięgu</translation>
    </message>
    <message>
        <source>Stay in port, hours</source>
        <translation>Postój w porcie, godziny</translation>
    </message>
    <message>
        <source>T&amp;ime</source>
        <translation>C&amp;zas</translation>
    </message>
    <message>
        <source>The ports are not loaded yet; try again in a moment.</source>
        <translation>Porty nie są jeszcze wczytane; spróbuj za chwilę.</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>Tam i z powrotem</translation>
    </message>
    <message>
        <source>Time there is</source>
        <translation>Dostępny czas</translation>
    </message>
    <message>
        <source>days</source>
        <translation>dni</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>godzin</translation>
    </message>
</context>
<context>
    <name>RecentPassages</name>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Wyczyść tę listę</translation>
    </message>
    <message>
        <source>None yet: what you calculate appears here</source>
        <translation>Jeszcze żadnych: tu pojawi się to, co obliczysz</translation>
    </message>
    <message>
        <source>via {place}</source>
        <translation>przez {place}</translation>
    </message>
    <message>
        <source>{start} – {end}</source>
        <translation>{start} – {end}</translation>
    </message>
</context>
<context>
    <name>ResultPanel</name>
    <message>
        <source>A check failed: do not sail it as it is.</source>
        <translation>Trasa nie przeszła sprawdzenia: nie płyń nią bez zmian.</translation>
    </message>
    <message>
        <source>A planning aid, not for navigation: shoals, traffic schemes and local rules are not in it. Check the passage on an official chart.</source>
        <translation>Narzędzie do planowania, nie do nawigacji: nie ma w nim płycizn, systemów rozgraniczenia ruchu ani przepisów lokalnych. Sprawdź trasę na mapie urzędowej.</translation>
    </message>
    <message>
        <source>Against the wind</source>
        <translation>Ostro na wiatr</translation>
    </message>
    <message>
        <source>Beyond the forecast</source>
        <translation>Poza prognozą</translation>
    </message>
    <message>
        <source>By way of</source>
        <translation>Przez</translation>
    </message>
    <message>
        <source>Checked leg by leg: {what}.</source>
        <translation>Sprawdzona odcinek po odcinku: {what}.</translation>
    </message>
    <message>
        <source>Departs {leaves}
Arrives {arrives}</source>
        <translation>Wyjście {leaves}
Przybycie {arrives}</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Droga</translation>
    </message>
    <message>
        <source>Earlier passage: {head}</source>
        <translation>Poprzednia trasa: {head}</translation>
    </message>
    <message>
        <source>Force {force} on the Beaufort scale</source>
        <translation>{force} w skali Beauforta</translation>
    </message>
    <message>
        <source>Hours with the sun more than 6° below the horizon</source>
        <translation>Godziny, gdy słońce jest ponad 6° pod horyzontem</translation>
    </message>
    <message>
        <source>In the dark</source>
        <translation>W nocy</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Średnia prędkość</translation>
    </message>
    <message>
        <source>No passage of hers in this wind takes less than {t}.</source>
        <translation>Przy tym wietrze ten jacht nie dopłynie szybciej niż w {t}.</translation>
    </message>
    <message>
        <source>Part of the time closer than {angle:.0f}° to the true wind</source>
        <translation>Część czasu bliżej niż {angle:.0f}° od wiatru rzeczywistego</translation>
    </message>
    <message>
        <source>Roughly so far: {head}</source>
        <translation>Na razie z grubsza: {head}</translation>
    </message>
    <message>
        <source>Strongest wind</source>
        <translation>Najsilniejszy wiatr</translation>
    </message>
    <message>
        <source>Tacks and gybes</source>
        <translation>Zwroty (sztag, rufa)</translation>
    </message>
    <message>
        <source>Under engine</source>
        <translation>Na silniku</translation>
    </message>
    <message>
        <source>Wind: {parts}.</source>
        <translation>Wiatr: {parts}.</translation>
    </message>
    <message>
        <source>clear of land</source>
        <translation>nie przecina lądu</translation>
    </message>
    <message>
        <source>issued {moment}, {age} ago</source>
        <translation>wydana {moment}, {age} temu</translation>
    </message>
    <message>
        <source>within your limits</source>
        <translation>w ramach twoich ograniczeń</translation>
    </message>
    <message>
        <source>{deg:g}° grid, every {step:g} h</source>
        <translation>siatka {deg:g}°, co {step:g} h</translation>
    </message>
    <message>
        <source>{direct} in a straight line</source>
        <translation>{direct} w linii prostej</translation>
    </message>
    <message>
        <source>{hours:.0f} h</source>
        <translation>{hours:.0f} h</translation>
    </message>
    <message>
        <source>{n:.1f} kn</source>
        <translation>{n:.1f} kn</translation>
    </message>
    <message>
        <source>{percent:.0f} %</source>
        <translation>{percent:.0f} %</translation>
    </message>
    <message>
        <source>{t} and {g}</source>
        <translation>{t} i {g}</translation>
    </message>
    <message>
        <source>{t}, {f:.0f} l</source>
        <translation>{t}, {f:.0f} l</translation>
    </message>
    <message>
        <source>{wind}, gusts {gusts}</source>
        <translation>{wind}, porywy {gusts}</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>, {age} old</source>
        <translation>, sprzed {age}</translation>
    </message>
    <message>
        <source>No wind loaded yet</source>
        <translation>Nie wczytano jeszcze wiatru</translation>
    </message>
    <message>
        <source>Position, wind and distance at the pointer</source>
        <translation>Pozycja, wiatr i odległość pod kursorem</translation>
    </message>
    <message>
        <source>Requests left today</source>
        <translation>Zapytania, które zostały na dziś</translation>
    </message>
    <message>
        <source>Source of the wind</source>
        <translation>Źródło wiatru</translation>
    </message>
    <message>
        <source>Storm Glass: {left} of {daily} requests left today</source>
        <translation>Storm Glass: na dziś zostało {left} z {daily} zapytań</translation>
    </message>
    <message>
        <source>Wind: {source}</source>
        <translation>Wiatr: {source}</translation>
    </message>
</context>
<context>
    <name>Steering</name>
    <message>
        <source>via</source>
        <translation>przez</translation>
    </message>
</context>
<context>
    <name>Succession</name>
    <message>
        <source>SEACRUISE_LANGUAGE decides on the language; the choice counts without it.</source>
        <translation>O języku decyduje SEACRUISE_LANGUAGE; wybór działa, gdy tej zmiennej nie ma.</translation>
    </message>
</context>
<context>
    <name>TimeBar</name>
    <message>
        <source>&amp;Leaves</source>
        <translation>W&amp;yjście</translation>
    </message>
    <message>
        <source>+{hours} h {minutes:02d}</source>
        <translation>+{hours} h {minutes:02d}</translation>
    </message>
    <message>
        <source>Departure</source>
        <translation>Wyjście</translation>
    </message>
    <message>
        <source>Drag the departure: the passage follows</source>
        <translation>Przeciągnij wyjście: trasa zmienia się od razu</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauza</translation>
    </message>
    <message>
        <source>Play the passage</source>
        <translation>Odtwórz trasę</translation>
    </message>
    <message>
        <source>Time along the passage</source>
        <translation>Chwila na trasie</translation>
    </message>
</context>
<context>
    <name>UnitsMenu</name>
    <message>
        <source>Distances in &amp;nautical miles</source>
        <translation>Odległości w &amp;milach morskich</translation>
    </message>
    <message>
        <source>Distances in k&amp;ilometres</source>
        <translation>Odległości w &amp;kilometrach</translation>
    </message>
    <message>
        <source>Times in &amp;UTC</source>
        <translation>Czas &amp;UTC</translation>
    </message>
    <message>
        <source>Times of this &amp;computer&apos;s zone, with the offset</source>
        <translation>Czas s&amp;trefy tego komputera, z przesunięciem</translation>
    </message>
    <message>
        <source>Waves and depths in &amp;feet</source>
        <translation>Fale i głębokości w &amp;stopach</translation>
    </message>
    <message>
        <source>Waves and depths in &amp;metres</source>
        <translation>Fale i głębokości w m&amp;etrach</translation>
    </message>
    <message>
        <source>Wind in &amp;Beaufort</source>
        <translation>Wiatr w skali &amp;Beauforta</translation>
    </message>
    <message>
        <source>Wind in &amp;knots</source>
        <translation>Wiatr w &amp;węzłach</translation>
    </message>
    <message>
        <source>Wind in metres a &amp;second</source>
        <translation>Wiatr w met&amp;rach na sekundę</translation>
    </message>
</context>
<context>
    <name>WeatherPage</name>
    <message>
        <source>&amp;After the end of the forecast</source>
        <translation>Po &amp;końcu prognozy</translation>
    </message>
    <message>
        <source>. Their spread tells how far they disagree.</source>
        <translation>. Ich rozrzut mówi, jak bardzo się różnią.</translation>
    </message>
    <message>
        <source>A passage that would end after the forecast is none.</source>
        <translation>Trasa, która skończyłaby się po końcu prognozy, jest odrzucana.</translation>
    </message>
    <message>
        <source>A service does not answer</source>
        <translation>Usługa nie odpowiada</translation>
    </message>
    <message>
        <source>After the end of the forecast</source>
        <translation>Po końcu prognozy</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Wybierz plik…</translation>
    </message>
    <message>
        <source>Drop a GRIB or NetCDF file anywhere on this page to see what it covers.</source>
        <translation>Upuść plik GRIB lub NetCDF w dowolnym miejscu tej strony, aby zobaczyć, co obejmuje.</translation>
    </message>
    <message>
        <source>Fade to the usual within a day</source>
        <translation>Przejdź do średniego w ciągu doby</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Pliki</translation>
    </message>
    <message>
        <source>Forecast files</source>
        <translation>Pliki prognozy</translation>
    </message>
    <message>
        <source>Forecasts are not kept</source>
        <translation>Prognozy nie są przechowywane</translation>
    </message>
    <message>
        <source>Hold the last wind</source>
        <translation>Utrzymaj ostatni wiatr</translation>
    </message>
    <message>
        <source>Mean of several</source>
        <translation>Średnia z kilku</translation>
    </message>
    <message>
        <source>Needs a key of your own.</source>
        <translation>Wymaga własnego klucza.</translation>
    </message>
    <message>
        <source>No connection</source>
        <translation>Brak połączenia</translation>
    </message>
    <message>
        <source>Passages are planned with {what}.</source>
        <translation>Trasy planuje się na podstawie: {what}.</translation>
    </message>
    <message>
        <source>Refuse to sail on</source>
        <translation>Nie płyń dalej</translation>
    </message>
    <message>
        <source>That did not work</source>
        <translation>To się nie udało</translation>
    </message>
    <message>
        <source>The last wind blows on; the result says for how long.</source>
        <translation>Ostatni wiatr wieje dalej; wynik mówi, jak długo.</translation>
    </message>
    <message>
        <source>The mean is in use</source>
        <translation>Średnia jest w użyciu</translation>
    </message>
    <message>
        <source>Tick two or more services or files to plan with their mean.</source>
        <translation>Zaznacz co najmniej dwie usługi lub pliki, aby planować z ich średnią.</translation>
    </message>
    <message>
        <source>Use the mean</source>
        <translation>Użyj średniej</translation>
    </message>
    <message>
        <source>Weather</source>
        <translation>Pogoda</translation>
    </message>
    <message>
        <source>What is kept is used meanwhile; files, practice weather and the sample need no network.</source>
        <translation>Tymczasem używane jest to, co przechowano; pliki, pogoda ćwiczebna i przykład nie wymagają sieci.</translation>
    </message>
    <message>
        <source>Within 24 hours it goes over to the mean of the forecast.</source>
        <translation>W ciągu 24 godzin przechodzi w średnią prognozy.</translation>
    </message>
    <message>
        <source>the mean of {parts}</source>
        <translation>średnia: {parts}</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Choose two ports, a departure and your yacht. SeaCruise finds the fastest passage under sail.</source>
        <translation>Wybierz dwa porty, termin wyjścia i swój jacht. SeaCruise znajdzie najszybszą trasę pod żaglami.</translation>
    </message>
    <message>
        <source>Ctrl+Enter calculates, Esc cancels, + and − zoom, the arrow keys move the chart.</source>
        <translation>Ctrl+Enter oblicza, Esc anuluje, + i − zmieniają skalę, strzałki przesuwają mapę.</translation>
    </message>
    <message>
        <source>Drop a polar file on the window to add your yacht, or a GRIB file to use its wind.</source>
        <translation>Upuść na okno plik biegunowej, aby dodać swój jacht, albo plik GRIB, aby użyć jego wiatru.</translation>
    </message>
    <message>
        <source>Is a week enough?</source>
        <translation>Czy wystarczy tydzień?</translation>
    </message>
    <message>
        <source>Right-click on the chart to sail from, to or via any position, or to avoid an area.</source>
        <translation>Kliknij mapę prawym przyciskiem, aby płynąć stąd, tutaj lub przez dowolną pozycję albo ominąć obszar.</translation>
    </message>
    <message>
        <source>Then drag the start, the end or the departure: the passage follows.</source>
        <translation>Potem przeciągnij start, cel albo wyjście: trasa zmienia się od razu.</translation>
    </message>
</context>
<context>
    <name>YachtPage</name>
    <message>
        <source> ({n} more)</source>
        <translation> (i jeszcze {n})</translation>
    </message>
    <message>
        <source>&amp;Add a polar…</source>
        <translation>Dod&amp;aj biegunową…</translation>
    </message>
    <message>
        <source>&amp;Fit from a log…</source>
        <translation>Do&amp;pasuj z dziennika…</translation>
    </message>
    <message>
        <source>&amp;Sail with her</source>
        <translation>Płyń tym jac&amp;htem</translation>
    </message>
    <message>
        <source>A polar file cannot be used</source>
        <translation>Nie można użyć pliku biegunowej</translation>
    </message>
    <message>
        <source>Add a polar</source>
        <translation>Dodaj biegunową</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Anulowano</translation>
    </message>
    <message>
        <source>Fit a polar to logs of this yacht</source>
        <translation>Dopasuj biegunową do dzienników tego jachtu</translation>
    </message>
    <message>
        <source>NMEA 0183, Signal K, or a table; this polar is what it starts from</source>
        <translation>NMEA 0183, Signal K albo tabela; punktem wyjścia jest ta biegunowa</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>Or drop the file here: it is checked and copied to your own</source>
        <translation>Albo upuść plik tutaj: zostanie sprawdzony i skopiowany do twojego folderu</translation>
    </message>
    <message>
        <source>Reading the yachts</source>
        <translation>Wczytywanie jachtów</translation>
    </message>
    <message>
        <source>Reading the yachts…</source>
        <translation>Wczytywanie jachtów…</translation>
    </message>
    <message>
        <source>Take her for the passage</source>
        <translation>Użyj tego jachtu na trasie</translation>
    </message>
    <message>
        <source>There are no yachts yet. Drop a polar file here, or add one.</source>
        <translation>Nie ma jeszcze jachtów. Upuść tu plik biegunowej albo go dodaj.</translation>
    </message>
    <message>
        <source>This polar was not taken</source>
        <translation>Tej biegunowej nie przyjęto</translation>
    </message>
    <message>
        <source>Yacht and polar</source>
        <translation>Jacht i biegunowa</translation>
    </message>
    <message>
        <source>Yachts</source>
        <translation>Jachty</translation>
    </message>
    <message>
        <source>{yacht} is in your fleet now.</source>
        <translation>{yacht} jest teraz w twojej flocie.</translation>
    </message>
</context>
<context>
    <name>YachtView</name>
    <message>
        <source>  {yacht}: {speed:.2f} kn.</source>
        <translation>  {yacht}: {speed:.2f} kn.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Tacking and gybing</source>
        <translation>&amp;Zwroty</translation>
    </message>
    <message>
        <source>&amp;Wind</source>
        <translation>Wiat&amp;r</translation>
    </message>
    <message>
        <source>At this angle</source>
        <translation>Przy tym kącie</translation>
    </message>
    <message>
        <source>C&amp;ompare</source>
        <translation>Porów&amp;naj</translation>
    </message>
    <message>
        <source>Compare with another yacht</source>
        <translation>Porównaj z innym jachtem</translation>
    </message>
    <message>
        <source>Dotted: what she makes good by turns on two headings</source>
        <translation>Kropkowane: zysk przy żegludze na przemian dwoma kursami</translation>
    </message>
    <message>
        <source>Per cent of the polar</source>
        <translation>Procent biegunowej</translation>
    </message>
    <message>
        <source>S&amp;ails at</source>
        <translation>Żegl&amp;uje na</translation>
    </message>
    <message>
        <source>Targets: best beat and run by wind</source>
        <translation>Cele: najlepsza halsówka i najlepszy pełny kurs według wiatru</translation>
    </message>
    <message>
        <source>True wind speed, knots</source>
        <translation>Prędkość wiatru rzeczywistego, węzły</translation>
    </message>
    <message>
        <source>with no other yacht</source>
        <translation>bez innego jachtu</translation>
    </message>
    <message>
        <source>{one} and {two} (dashed)</source>
        <translation>{one} i {two} (kreskowane)</translation>
    </message>
    <message>
        <source>{tws} kn</source>
        <translation>{tws} kn</translation>
    </message>
</context>
<context>
    <name>chart</name>
    <message>
        <source>&amp;Avoid this area</source>
        <translation>&amp;Omiń ten obszar</translation>
    </message>
    <message>
        <source>&amp;Measure from here</source>
        <translation>&amp;Mierz stąd</translation>
    </message>
    <message>
        <source>In {n} members: {hours}</source>
        <translation>W członach ({n}): {hours}</translation>
    </message>
    <message>
        <source>No longer avoid “{name}”</source>
        <translation>Nie omijaj już „{name}”</translation>
    </message>
    <message>
        <source>Sail &amp;direct again</source>
        <translation>Płyń znów &amp;bezpośrednio</translation>
    </message>
    <message>
        <source>Sail &amp;from here</source>
        <translation>Płyń &amp;stąd</translation>
    </message>
    <message>
        <source>Sail &amp;to here</source>
        <translation>Płyń &amp;tutaj</translation>
    </message>
    <message>
        <source>Sail &amp;via here</source>
        <translation>Płyń &amp;przez to miejsce</translation>
    </message>
    <message>
        <source>Sail {way}</source>
        <translation>Płyń: {way}</translation>
    </message>
    <message>
        <source>{miles:g} nm</source>
        <translation>{miles:g} Mm</translation>
    </message>
    <message>
        <source>{radius} nm around</source>
        <translation>w promieniu {radius} Mm</translation>
    </message>
</context>
<context>
    <name>coarse</name>
    <message>
        <source>Coarse coast: no islets, no depths.</source>
        <translation>Wybrzeże uproszczone: bez wysepek i głębokości.</translation>
    </message>
    <message>
        <source>Routing sees land to 1 km here.</source>
        <translation>Tutaj obliczenia widzą ląd z dokładnością do 1 km.</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>, each for {} members of the ensemble,</source>
        <translation>, każda dla {} członów wiązki,</translation>
    </message>
    <message>
        <source>; the service could not be reached</source>
        <translation>; z usługą nie udało się połączyć</translation>
    </message>
    <message>
        <source>; {} were planned</source>
        <translation>; planowano: {}</translation>
    </message>
    <message>
        <source>A boat speed [kn] to start the engine below</source>
        <translation>Prędkość jachtu, poniżej której uruchamia się silnik [kn]</translation>
    </message>
    <message>
        <source>A course of {} degrees for {} s cannot be sailed; give both anew.</source>
        <translation>Kursu {} stopni przez {} s nie da się płynąć; podaj oba na nowo.</translation>
    </message>
    <message>
        <source>A curve needs {} steady points or more and the log has {}; give more logs, or fit a table.</source>
        <translation>Krzywa wymaga co najmniej {} ustalonych punktów, a w dzienniku jest ich {}; podaj więcej dzienników albo dopasuj tabelę.</translation>
    </message>
    <message>
        <source>A distance from the shore [nm]</source>
        <translation>Odległość od brzegu [Mm]</translation>
    </message>
    <message>
        <source>A fuel rate [l/h]</source>
        <translation>Zużycie paliwa [l/h]</translation>
    </message>
    <message>
        <source>A grid needs south below north, west before east and two rows and columns at least.</source>
        <translation>Siatka wymaga południa poniżej północy, zachodu przed wschodem oraz co najmniej dwóch wierszy i kolumn.</translation>
    </message>
    <message>
        <source>A helper process that computed passages ended before its time; try again with fewer of them.</source>
        <translation>Proces pomocniczy, który liczył trasy, zakończył się przed czasem; spróbuj z mniejszą ich liczbą.</translation>
    </message>
    <message>
        <source>A lattice of more than {} vertices is too fine for this computer; choose a wider spacing or a shorter passage.</source>
        <translation>Siatka o ponad {} wierzchołkach jest za gęsta dla tego komputera; wybierz większy odstęp albo krótszą trasę.</translation>
    </message>
    <message>
        <source>A length of boards [h]</source>
        <translation>Długość halsów [h]</translation>
    </message>
    <message>
        <source>A length of {} m is out of range; give 3 to 100 m.</source>
        <translation>Długość {} m jest poza zakresem; podaj od 3 do 100 m.</translation>
    </message>
    <message>
        <source>A limit of gusts [kn]</source>
        <translation>Ograniczenie porywów [kn]</translation>
    </message>
    <message>
        <source>A limit of the wave height [m]</source>
        <translation>Ograniczenie wysokości fali [m]</translation>
    </message>
    <message>
        <source>A log has no column {}; there are {}.</source>
        <translation>Dziennik nie ma kolumny {}; ma: {}.</translation>
    </message>
    <message>
        <source>A loss of speed for each metre of waves [%]</source>
        <translation>Strata prędkości na każdy metr fali [%]</translation>
    </message>
    <message>
        <source>A loss of {} a metre of waves is out of range; give 0 to 1.</source>
        <translation>Strata {} na metr fali jest poza zakresem; podaj od 0 do 1.</translation>
    </message>
    <message>
        <source>A number of safety levels</source>
        <translation>Liczba poziomów bezpieczeństwa</translation>
    </message>
    <message>
        <source>A number of tacks and gybes</source>
        <translation>Liczba zwrotów</translation>
    </message>
    <message>
        <source>A penalty for turning [min for 10 degrees]</source>
        <translation>Kara za zmianę kursu [min na 10 stopni]</translation>
    </message>
    <message>
        <source>A percentage of the polar</source>
        <translation>Procent biegunowej</translation>
    </message>
    <message>
        <source>A percentage of the speed at night</source>
        <translation>Procent prędkości w nocy</translation>
    </message>
    <message>
        <source>A point of the log is no finite number; leave it out.</source>
        <translation>Punkt dziennika nie jest skończoną liczbą; pomiń go.</translation>
    </message>
    <message>
        <source>A radius of safety zones [nm]</source>
        <translation>Promień stref bezpieczeństwa [Mm]</translation>
    </message>
    <message>
        <source>A safety radius of {} nm is wider than the sea&apos;s raster can tell; give up to {} nm.</source>
        <translation>Promień bezpieczeństwa {} Mm jest większy, niż rozróżnia raster morza; podaj najwyżej {} Mm.</translation>
    </message>
    <message>
        <source>A saved passage needs a name; type one.</source>
        <translation>Zapisana trasa potrzebuje nazwy; wpisz ją.</translation>
    </message>
    <message>
        <source>A second grid of {} degrees in the file is not used.</source>
        <translation>Druga siatka w pliku, o oczku {} stopni, nie jest używana.</translation>
    </message>
    <message>
        <source>A share of speed at night of {} is out of range; give 0.1 to 1.</source>
        <translation>Ułamek prędkości w nocy {} jest poza zakresem; podaj od 0,1 do 1.</translation>
    </message>
    <message>
        <source>A simulation needs a departure with a time zone (--depart).</source>
        <translation>Symulacja wymaga terminu wyjścia ze strefą czasową (--depart).</translation>
    </message>
    <message>
        <source>A simulation needs at least one forecast.</source>
        <translation>Symulacja wymaga co najmniej jednej prognozy.</translation>
    </message>
    <message>
        <source>A spacing [nm]</source>
        <translation>Odstęp [Mm]</translation>
    </message>
    <message>
        <source>A speed under engine [kn]</source>
        <translation>Prędkość na silniku [kn]</translation>
    </message>
    <message>
        <source>A stay of {} h does not fit into {} h; give less, or more time.</source>
        <translation>Postój {} h nie mieści się w {} h; podaj krótszy albo więcej czasu.</translation>
    </message>
    <message>
        <source>A time to wait [h]</source>
        <translation>Czas oczekiwania [h]</translation>
    </message>
    <message>
        <source>A weight of a forecast must be a number above 0; leave out forecasts without any.</source>
        <translation>Waga prognozy musi być liczbą większą od 0; prognozy bez wagi pomiń.</translation>
    </message>
    <message>
        <source>A wind limit [kn]</source>
        <translation>Ograniczenie wiatru [kn]</translation>
    </message>
    <message>
        <source>A wind speed of a picture is out of range; give 0.5 to 100 kn.</source>
        <translation>Prędkość wiatru na wykresie jest poza zakresem; podaj od 0,5 do 100 kn.</translation>
    </message>
    <message>
        <source>A {} lattice cannot have {} directions; choose {}.</source>
        <translation>Siatka {} nie może mieć tylu kierunków: {}; wybierz {}.</translation>
    </message>
    <message>
        <source>After the forecast one can {}, not {}.</source>
        <translation>Po końcu prognozy można wybrać {}, a nie {}.</translation>
    </message>
    <message>
        <source>At {} the passage is not under way: it is from {} to {}. Give a time in between (--time), or where she is (--at).</source>
        <translation>O {} jacht nie jest w drodze: trasa trwa od {} do {}. Podaj chwilę pomiędzy (--time) albo pozycję jachtu (--at).</translation>
    </message>
    <message>
        <source>Building the lattice</source>
        <translation>Budowanie siatki</translation>
    </message>
    <message>
        <source>CSV file</source>
        <translation>plik CSV</translation>
    </message>
    <message>
        <source>Computed on {} UTC with {}</source>
        <translation>Obliczono {} UTC, wiatr: {}</translation>
    </message>
    <message>
        <source>Computed on {} UTC with {}.</source>
        <translation>Obliczono {} UTC, wiatr: {}.</translation>
    </message>
    <message>
        <source>Drawing lines of equal time</source>
        <translation>Rysowanie linii równego czasu</translation>
    </message>
    <message>
        <source>Every way leads at some time through the yacht&apos;s dead angle, and tacking is not allowed; allow it (the precise preset does) or leave at another time.</source>
        <translation>Każda droga prowadzi w pewnej chwili przez martwy kąt jachtu, a halsowanie jest niedozwolone; zezwól na nie (ustawienie precise to robi) albo wyjdź o innej porze.</translation>
    </message>
    <message>
        <source>Every way leads through a zone that is closed to you; take the zone out of the layers, or leave when it is open.</source>
        <translation>Każda droga prowadzi przez strefę, która jest dla ciebie zamknięta; usuń strefę z warstw albo wyjdź, gdy będzie otwarta.</translation>
    </message>
    <message>
        <source>Every way leads through higher waves or stronger gusts than you allow; leave at another time or raise the limit.</source>
        <translation>Każda droga prowadzi przez fale wyższe lub porywy silniejsze, niż dopuszczasz; wyjdź o innej porze albo podnieś ograniczenie.</translation>
    </message>
    <message>
        <source>Every way leads through more wind than the {} kn you allow; leave at another time or raise the limit.</source>
        <translation>Każda droga prowadzi przez wiatr silniejszy niż dopuszczone {} kn; wyjdź o innej porze albo podnieś ograniczenie.</translation>
    </message>
    <message>
        <source>File {}</source>
        <translation>Plik {}</translation>
    </message>
    <message>
        <source>Fitting a curve needs SciPy, which is not installed; install seacruise[fit], or fit a table or a cloud.</source>
        <translation>Dopasowanie krzywej wymaga pakietu SciPy, który nie jest zainstalowany; zainstaluj seacruise[fit] albo dopasuj tabelę lub chmurę.</translation>
    </message>
    <message>
        <source>Forecasts are not kept. {}</source>
        <translation>Prognozy nie są przechowywane. {}</translation>
    </message>
    <message>
        <source>GFS analyses of NOAA, public domain.</source>
        <translation>Analizy GFS (NOAA), domena publiczna.</translation>
    </message>
    <message>
        <source>GPX file</source>
        <translation>plik GPX</translation>
    </message>
    <message>
        <source>GRIB 1, GRIB 2 or CF NetCDF</source>
        <translation>GRIB 1, GRIB 2 albo NetCDF CF</translation>
    </message>
    <message>
        <source>GRIB files need the package eccodes, which is not installed or cannot find its library: install it with &apos;pip install eccodes&apos;, or use a NetCDF file ({}).</source>
        <translation>Pliki GRIB wymagają pakietu eccodes, który nie jest zainstalowany albo nie znajduje swojej biblioteki: zainstaluj go poleceniem „pip install eccodes” albo użyj pliku NetCDF ({}).</translation>
    </message>
    <message>
        <source>GeoJSON file</source>
        <translation>plik GeoJSON</translation>
    </message>
    <message>
        <source>Getting the wind</source>
        <translation>Pobieranie prognozy wiatru</translation>
    </message>
    <message>
        <source>Gusts are known until {}; after that the mean wind stands for them.</source>
        <translation>Porywy są znane do {}; potem zastępuje je wiatr średni.</translation>
    </message>
    <message>
        <source>Hours after a hole of more than {} h are not used.</source>
        <translation>Godziny po przerwie dłuższej niż {} h nie są używane.</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>to jest folder</translation>
    </message>
    <message>
        <source>It stands in because no Storm Glass key is set and Open-Meteo failed ({}).</source>
        <translation>Zastępuje prognozę, bo nie ma klucza Storm Glass, a Open-Meteo zawiodło ({}).</translation>
    </message>
    <message>
        <source>Its answers were asked for another passage and lie up to {} nm away from this one.</source>
        <translation>Dane pobrano dla innej trasy; leżą do {} Mm od tej.</translation>
    </message>
    <message>
        <source>KML file</source>
        <translation>plik KML</translation>
    </message>
    <message>
        <source>Looking at the other side of {}</source>
        <translation>Sprawdzanie drugiej strony: {}</translation>
    </message>
    <message>
        <source>Looking for a passage with at most {} tacks and gybes</source>
        <translation>Szukanie trasy, na której zwrotów jest najwyżej {}</translation>
    </message>
    <message>
        <source>MET Norway</source>
        <translation>MET Norway</translation>
    </message>
    <message>
        <source>MET Norway will soon end this version of its service; look for a newer SeaCruise.</source>
        <translation>MET Norway wkrótce zakończy tę wersję swojej usługi; poszukaj nowszej wersji SeaCruise.</translation>
    </message>
    <message>
        <source>Mean of {}</source>
        <translation>Średnia: {}</translation>
    </message>
    <message>
        <source>More than one port fits {}: {}</source>
        <translation>Nazwa {} pasuje do więcej niż jednego portu: {}</translation>
    </message>
    <message>
        <source>More than one yacht fits {}: {}</source>
        <translation>Nazwa {} pasuje do więcej niż jednego jachtu: {}</translation>
    </message>
    <message>
        <source>More than {} nm from the water that is connected with the open sea, to which the time counts: {}.</source>
        <translation>Dalej niż {} Mm od wody połączonej z otwartym morzem, do której liczy się czas: {}.</translation>
    </message>
    <message>
        <source>Most sound sentences carry a wrong checksum, so checksums were not looked at.</source>
        <translation>Większość poprawnych zdań ma błędną sumę kontrolną, więc sum nie sprawdzano.</translation>
    </message>
    <message>
        <source>No forecast is issued by the departure at {}; the first one ({}) is of {}.</source>
        <translation>Do chwili wyjścia {} nie wydano żadnej prognozy; pierwsza ({}) jest z {}.</translation>
    </message>
    <message>
        <source>No forecast was named; {}.</source>
        <translation>Nie podano prognozy; {}.</translation>
    </message>
    <message>
        <source>No message is of vessels.self and no greeting says which vessel is the own one.</source>
        <translation>Żaden komunikat nie jest z vessels.self i żadne powitanie nie mówi, która jednostka jest własna.</translation>
    </message>
    <message>
        <source>No port is reached: the time is too short, the wind too light, or stronger than is allowed.</source>
        <translation>Żaden port nie jest osiągalny: za mało czasu, za słaby wiatr albo silniejszy, niż dopuszczasz.</translation>
    </message>
    <message>
        <source>No port was named; give a name such as Gdynia, or a position such as 54.5,18.6.</source>
        <translation>Nie podano portu; wpisz nazwę, np. Gdynia, albo pozycję, np. 54.5,18.6.</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>brak miejsca na dysku</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>nie ma takiego pliku ani folderu</translation>
    </message>
    <message>
        <source>No yacht was named; give a name such as Bavaria 46 Cruiser, or a polar file.</source>
        <translation>Nie podano jachtu; wpisz nazwę, np. Bavaria 46 Cruiser, albo plik biegunowej.</translation>
    </message>
    <message>
        <source>No yacht was named; give one to draw.</source>
        <translation>Nie podano jachtu; wskaż jacht do narysowania.</translation>
    </message>
    <message>
        <source>ORC certificate {} {}</source>
        <translation>Świadectwo ORC {} {}</translation>
    </message>
    <message>
        <source>ORC certificate {}: {}, {}; collected by {}</source>
        <translation>Świadectwo ORC {}: {}, {}; zebrane przez {}</translation>
    </message>
    <message>
        <source>Of the forecasts in the file, the ensemble is used.</source>
        <translation>Z prognoz w pliku używana jest wiązka.</translation>
    </message>
    <message>
        <source>Of {} layers ({}) of the {}, the first one is used.</source>
        <translation>Z warstw w liczbie {} ({}) dla {} używana jest pierwsza.</translation>
    </message>
    <message>
        <source>Of {} model runs, the latest is used for each hour.</source>
        <translation>Z przebiegów modelu w liczbie {} dla każdej godziny używany jest najnowszy.</translation>
    </message>
    <message>
        <source>Only {} of {} planned places were asked: no more requests were left today.</source>
        <translation>Zapytano tylko o {} z {} zaplanowanych miejsc: na dziś nie zostało więcej zapytań.</translation>
    </message>
    <message>
        <source>Only {} of {} steady means have the weight that is asked for; leave out fewer (--drop, --least-weight), or weigh in another way (--weigh).</source>
        <translation>Tylko {} z {} ustalonych średnich ma żądaną wagę; pomiń mniej (--drop, --least-weight) albo waż inaczej (--weigh).</translation>
    </message>
    <message>
        <source>Open-Meteo, because no Storm Glass key is set; practice weather when that fails</source>
        <translation>Open-Meteo, bo nie ma klucza Storm Glass; gdy zawiedzie, pogoda ćwiczebna</translation>
    </message>
    <message>
        <source>Outside 9 to 31° E and 53 to 66° N the coast is known to 1 km only: islets are missing there, keep well off every shore.</source>
        <translation>Poza obszarem 9–31° E i 53–66° N wybrzeże jest znane tylko z dokładnością do 1 km: brakuje tam wysepek, trzymaj się z dala od każdego brzegu.</translation>
    </message>
    <message>
        <source>PDF file</source>
        <translation>plik PDF</translation>
    </message>
    <message>
        <source>Passage 1 of {}</source>
        <translation>Trasa 1 z {}</translation>
    </message>
    <message>
        <source>Passage {} of {}</source>
        <translation>Trasa {} z {}</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>brak uprawnień</translation>
    </message>
    <message>
        <source>Practice weather - generated, not a forecast</source>
        <translation>Pogoda ćwiczebna – wygenerowana, to nie prognoza</translation>
    </message>
    <message>
        <source>Practice weather, not a forecast. {}</source>
        <translation>Pogoda ćwiczebna, to nie prognoza. {}</translation>
    </message>
    <message>
        <source>Practice weather: generated, not a forecast.</source>
        <translation>Pogoda ćwiczebna: wygenerowana, to nie prognoza.</translation>
    </message>
    <message>
        <source>Reading the sea</source>
        <translation>Wczytywanie morza</translation>
    </message>
    <message>
        <source>Reading {}</source>
        <translation>Wczytywanie: {}</translation>
    </message>
    <message>
        <source>Refining the passage</source>
        <translation>Wygładzanie trasy</translation>
    </message>
    <message>
        <source>Safety zones need both, a radius and a number of levels from 1 to 6.</source>
        <translation>Strefy bezpieczeństwa wymagają obu wartości: promienia i liczby poziomów od 1 do 6.</translation>
    </message>
    <message>
        <source>Sail {}</source>
        <translation>Żagiel {}</translation>
    </message>
    <message>
        <source>Sailed again she is becalmed on the way to {}.</source>
        <translation>Sprawdzenie: jacht staje w ciszy w drodze do: {}.</translation>
    </message>
    <message>
        <source>Sailed again the way touches land on the way to {}.</source>
        <translation>Sprawdzenie: lądu dotyka droga do: {}.</translation>
    </message>
    <message>
        <source>Sailing the passage again</source>
        <translation>Sprawdzanie trasy odcinek po odcinku</translation>
    </message>
    <message>
        <source>Sailing the ways out again</source>
        <translation>Sprawdzanie dróg tam</translation>
    </message>
    <message>
        <source>Saint Petersburg</source>
        <translation>Saint Petersburg</translation>
    </message>
    <message>
        <source>Sample weather: real analyses of 20-22 November 2016, not a forecast.</source>
        <translation>Pogoda przykładowa: rzeczywiste analizy z 20–22 listopada 2016, to nie prognoza.</translation>
    </message>
    <message>
        <source>Sample: real Baltic analyses, 20-22 Nov 2016 (NOAA GFS)</source>
        <translation>Przykład: analizy dla Bałtyku, 20–22 listopada 2016 (NOAA GFS)</translation>
    </message>
    <message>
        <source>SeaCruise is not installed completely: {} is missing; install it again.</source>
        <translation>SeaCruise nie jest zainstalowany w całości: brakuje {}; zainstaluj go ponownie.</translation>
    </message>
    <message>
        <source>Searching the approach of {}</source>
        <translation>Przeszukiwanie podejścia: {}</translation>
    </message>
    <message>
        <source>Searching the ways back</source>
        <translation>Przeszukiwanie dróg powrotnych</translation>
    </message>
    <message>
        <source>Searching {} courses at {} vertices</source>
        <translation>Przeszukiwanie: kursów {}, wierzchołków {}</translation>
    </message>
    <message>
        <source>Searching {} vertices</source>
        <translation>Przeszukiwanie: wierzchołków {}</translation>
    </message>
    <message>
        <source>She cannot be there by {} UTC: the earliest departure with a forecast is {} UTC</source>
        <translation>Jacht nie może być na miejscu do {} UTC: najwcześniejsze wyjście objęte prognozą to {} UTC</translation>
    </message>
    <message>
        <source>She is at {} already; there is nothing left to plan.</source>
        <translation>Jacht jest już na miejscu ({}); nie ma czego planować.</translation>
    </message>
    <message>
        <source>She keeps {} nm off every shore, but on the ways out of and into the ports.</source>
        <translation>Jacht trzyma się {} Mm od każdego brzegu, poza drogami z portów i do portów.</translation>
    </message>
    <message>
        <source>She sets out {} nm from {}, at the nearest water of the chart that is connected with the open sea.</source>
        <translation>Jacht wyrusza {} Mm od punktu {}, z najbliższej wody na mapie połączonej z otwartym morzem.</translation>
    </message>
    <message>
        <source>She tacks and gybes {} times: no passage with only {} was found.</source>
        <translation>Zwroty na tej trasie: {}; trasy, na której byłoby ich tylko {}, nie znaleziono.</translation>
    </message>
    <message>
        <source>She waits {} h in {}, until what you do not allow has passed.</source>
        <translation>Jacht czeka {} h w porcie {}, aż miną warunki, których nie dopuszczasz.</translation>
    </message>
    <message>
        <source>Some of the wind is from an answer {} h old.</source>
        <translation>Część danych o wietrze jest sprzed {} h.</translation>
    </message>
    <message>
        <source>Some of what is in the file besides the wind is not used: {}.</source>
        <translation>Część zawartości pliku poza wiatrem nie jest używana: {}.</translation>
    </message>
    <message>
        <source>Something else answered in place of {} (a page, not data): a hotel or harbour network may want you to sign in first; open a web page, then try again.</source>
        <translation>Zamiast {} odpowiedziało coś innego (strona, nie dane): sieć hotelowa lub portowa może wymagać zalogowania; otwórz stronę w przeglądarce i spróbuj ponownie.</translation>
    </message>
    <message>
        <source>St Petersburg</source>
        <translation>St Petersburg</translation>
    </message>
    <message>
        <source>Start and end are the same place ({}); choose two different ports.</source>
        <translation>Start i cel to to samo miejsce ({}); wybierz dwa różne porty.</translation>
    </message>
    <message>
        <source>Storm Glass</source>
        <translation>Storm Glass</translation>
    </message>
    <message>
        <source>Storm Glass answered for another place than the one asked; try again later.</source>
        <translation>Storm Glass odpowiedziało dla innego miejsca, niż zapytano; spróbuj później.</translation>
    </message>
    <message>
        <source>Storm Glass answered for other days than those asked; check this computer&apos;s date.</source>
        <translation>Storm Glass odpowiedziało dla innych dni, niż zapytano; sprawdź datę tego komputera.</translation>
    </message>
    <message>
        <source>Storm Glass does not accept the key; correct STORMGLASS_API_KEY (see your page there).</source>
        <translation>Storm Glass nie przyjmuje klucza; popraw STORMGLASS_API_KEY (zobacz swoją stronę w serwisie).</translation>
    </message>
    <message>
        <source>Storm Glass does not understand the request: {}.</source>
        <translation>Storm Glass nie rozumie zapytania: {}.</translation>
    </message>
    <message>
        <source>Storm Glass needs a key: set STORMGLASS_API_KEY to yours (a free one is at stormglass.io), or plan with practice weather or a file.</source>
        <translation>Storm Glass wymaga klucza: ustaw swój w STORMGLASS_API_KEY (bezpłatny jest na stormglass.io) albo planuj z pogodą ćwiczebną lub plikiem.</translation>
    </message>
    <message>
        <source>Storm Glass sent a wind of {} m/s, which cannot be; try again later.</source>
        <translation>Storm Glass przysłało wiatr {} m/s, co jest niemożliwe; spróbuj później.</translation>
    </message>
    <message>
        <source>Storm Glass sent an answer without a single hour; try again later.</source>
        <translation>Storm Glass przysłało odpowiedź bez ani jednej godziny; spróbuj później.</translation>
    </message>
    <message>
        <source>Storm Glass sent less than {} hours of wind; try again later.</source>
        <translation>Storm Glass przysłało mniej niż {} h wiatru; spróbuj później.</translation>
    </message>
    <message>
        <source>Storm Glass sent no wind speed with a direction for any hour; try again later.</source>
        <translation>Storm Glass nie przysłało prędkości wiatru z kierunkiem dla żadnej godziny; spróbuj później.</translation>
    </message>
    <message>
        <source>Storm Glass {} for today; the quota resets at 00:00 UTC. Until then plan with practice weather or a file.</source>
        <translation>Storm Glass {} na dziś; limit odnawia się o 00:00 UTC. Do tego czasu planuj z pogodą ćwiczebną lub plikiem.</translation>
    </message>
    <message>
        <source>Storm Glass, because a key is set</source>
        <translation>Storm Glass, bo klucz jest ustawiony</translation>
    </message>
    <message>
        <source>Storm Glass: no request needed, {} left today</source>
        <translation>Storm Glass: zapytanie niepotrzebne, na dziś zostało {}</translation>
    </message>
    <message>
        <source>Storm Glass: {}, {}{}</source>
        <translation>Storm Glass: {}, {}{}</translation>
    </message>
    <message>
        <source>The address or the key of {} in the environment is not valid.</source>
        <translation>Adres lub klucz {} w zmiennych środowiska jest nieprawidłowy.</translation>
    </message>
    <message>
        <source>The answers of Storm Glass for this passage have no hours in common; try again.</source>
        <translation>Odpowiedzi Storm Glass dla tej trasy nie mają wspólnych godzin; spróbuj ponownie.</translation>
    </message>
    <message>
        <source>The arrival needs a time zone; give it in UTC, for example 2016-11-22T18:00Z.</source>
        <translation>Termin przybycia wymaga strefy czasowej; podaj go w UTC, np. 2016-11-22T18:00Z.</translation>
    </message>
    <message>
        <source>The classic preset has 12 directions; choose --preset precise for more.</source>
        <translation>Ustawienie classic ma 12 kierunków; dla większej liczby wybierz --preset precise.</translation>
    </message>
    <message>
        <source>The classic preset has its own lattice; choose --preset precise for another or for safety zones.</source>
        <translation>Ustawienie classic ma własną siatkę; dla innej lub dla stref bezpieczeństwa wybierz --preset precise.</translation>
    </message>
    <message>
        <source>The classic preset knows no cost of manoeuvres; choose --preset precise for them.</source>
        <translation>Ustawienie classic nie zna kosztu zwrotów; wybierz dla nich --preset precise.</translation>
    </message>
    <message>
        <source>The connection to {} broke off in the middle of an answer; try again.</source>
        <translation>Połączenie z {} zostało przerwane w połowie odpowiedzi; spróbuj ponownie.</translation>
    </message>
    <message>
        <source>The cost of a gybe [min]</source>
        <translation>Koszt zwrotu przez rufę [min]</translation>
    </message>
    <message>
        <source>The cost of a tack [min]</source>
        <translation>Koszt zwrotu przez sztag [min]</translation>
    </message>
    <message>
        <source>The current ({}) covers {} to {} UTC, and the wind ({}) {} to {} UTC; choose a current of the same days, or none.</source>
        <translation>Prąd ({}) obejmuje czas od {} do {} UTC, a wiatr ({}) od {} do {} UTC; wybierz prąd z tych samych dni albo żaden.</translation>
    </message>
    <message>
        <source>The current ({}) ends at {} UTC; the last is held.</source>
        <translation>Prąd ({}) kończy się {} UTC; ostatni jest utrzymany.</translation>
    </message>
    <message>
        <source>The current in the file is not used: {}.</source>
        <translation>Prąd z pliku nie jest używany: {}.</translation>
    </message>
    <message>
        <source>The current is from {}.</source>
        <translation>Źródło prądu: {}.</translation>
    </message>
    <message>
        <source>The curve of {} cannot be used: its parameters or limits are no numbers in range.</source>
        <translation>Krzywej jachtu {} nie można użyć: jej parametry lub granice nie są liczbami w zakresie.</translation>
    </message>
    <message>
        <source>The density of a cost gave {} figures for {} marks; it must give one each.</source>
        <translation>Gęstość kosztu dała tyle liczb: {}, dla tylu znaków: {}; ma dać po jednej.</translation>
    </message>
    <message>
        <source>The departure needs a time zone; give it in UTC, for example 2016-11-20T06:00Z.</source>
        <translation>Termin wyjścia wymaga strefy czasowej; podaj go w UTC, np. 2016-11-20T06:00Z.</translation>
    </message>
    <message>
        <source>The departure {} UTC is outside the forecast ({}), which covers {} to {} UTC; choose a time within it.</source>
        <translation>Wyjście {} UTC jest poza prognozą ({}), która obejmuje czas od {} do {} UTC; wybierz chwilę w tym zakresie.</translation>
    </message>
    <message>
        <source>The file holds a single time; its wind is held from then on.</source>
        <translation>Plik zawiera jedną chwilę; jej wiatr jest dalej utrzymany.</translation>
    </message>
    <message>
        <source>The file in REQUESTS_CA_BUNDLE or SSL_CERT_FILE does not exist; correct it.</source>
        <translation>Plik z REQUESTS_CA_BUNDLE lub SSL_CERT_FILE nie istnieje; popraw to.</translation>
    </message>
    <message>
        <source>The file is cut off after {} messages.</source>
        <translation>Plik jest ucięty; całych komunikatów: {}.</translation>
    </message>
    <message>
        <source>The file mixes {} grids; the one with the most hours is used.</source>
        <translation>Plik miesza siatki w liczbie {}; używana jest ta z największą liczbą godzin.</translation>
    </message>
    <message>
        <source>The file {} cannot be used ({}).</source>
        <translation>Pliku {} nie można użyć ({}).</translation>
    </message>
    <message>
        <source>The file {} cannot be written: the disk is full.</source>
        <translation>Nie można zapisać pliku {}: dysk jest pełny.</translation>
    </message>
    <message>
        <source>The file {} cannot be written; set SEACRUISE_HOME to a folder of yours.</source>
        <translation>Nie można zapisać pliku {}; ustaw SEACRUISE_HOME na własny folder.</translation>
    </message>
    <message>
        <source>The file {} is damaged; move it away and SeaCruise makes a new one.</source>
        <translation>Plik {} jest uszkodzony; przenieś go, a SeaCruise utworzy nowy.</translation>
    </message>
    <message>
        <source>The file {} is in use by another program; close that and try again.</source>
        <translation>Plik {} jest używany przez inny program; zamknij go i spróbuj ponownie.</translation>
    </message>
    <message>
        <source>The file {} is of a newer SeaCruise; update, or set SEACRUISE_HOME elsewhere.</source>
        <translation>Plik {} pochodzi z nowszej wersji SeaCruise; zaktualizuj program albo ustaw SEACRUISE_HOME gdzie indziej.</translation>
    </message>
    <message>
        <source>The file {} {}.</source>
        <translation>Plik {} {}.</translation>
    </message>
    <message>
        <source>The folder {} cannot be made ({}); set SEACRUISE_HOME.</source>
        <translation>Nie można utworzyć folderu {} ({}); ustaw SEACRUISE_HOME.</translation>
    </message>
    <message>
        <source>The folder {} cannot be read: {}.</source>
        <translation>Nie można odczytać folderu {}: {}.</translation>
    </message>
    <message>
        <source>The forecast ends; from here on its last wind fades to the usual.</source>
        <translation>Koniec prognozy; odtąd jej ostatni wiatr przechodzi stopniowo w średni.</translation>
    </message>
    <message>
        <source>The forecast ends; from here on its last wind is held.</source>
        <translation>Koniec prognozy; odtąd utrzymany jest jej ostatni wiatr.</translation>
    </message>
    <message>
        <source>The forecast has {}: what you do not allow of them was not looked at.</source>
        <translation>W prognozie są braki ({}): twoich ograniczeń dla tych wielkości nie sprawdzono.</translation>
    </message>
    <message>
        <source>The forecast {} cannot be averaged with others; give it alone, or only services and files.</source>
        <translation>Prognozy {} nie można uśrednić z innymi; podaj ją samą albo tylko usługi i pliki.</translation>
    </message>
    <message>
        <source>The forecast {} does not tell when it was issued; give it (--issued).</source>
        <translation>Prognoza {} nie mówi, kiedy ją wydano; podaj to (--issued).</translation>
    </message>
    <message>
        <source>The forecasts have only {} UTC in common; its wind is held from then.</source>
        <translation>Prognozy mają wspólną tylko chwilę {} UTC; jej wiatr jest dalej utrzymany.</translation>
    </message>
    <message>
        <source>The key in STORMGLASS_API_KEY has characters that no key has; copy it again without spaces.</source>
        <translation>Klucz w STORMGLASS_API_KEY zawiera znaki, których żaden klucz nie ma; skopiuj go jeszcze raz, bez spacji.</translation>
    </message>
    <message>
        <source>The last {} h are sailed in the last known wind, {} beyond the end of the forecast.</source>
        <translation>Ostatnie {} h płynie się na ostatnim znanym wietrze, {} po końcu prognozy.</translation>
    </message>
    <message>
        <source>The list of landmarks {} cannot be read: {}.</source>
        <translation>Nie można odczytać listy znaków {}: {}.</translation>
    </message>
    <message>
        <source>The list of points {} cannot be read: {}.</source>
        <translation>Nie można odczytać listy punktów {}: {}.</translation>
    </message>
    <message>
        <source>The list of ports {} cannot be read: {}.</source>
        <translation>Nie można odczytać listy portów {}: {}.</translation>
    </message>
    <message>
        <source>The log has steady sailing at {} wind speeds and {} angles only; a polar needs two of each: give more logs, or a polar to start from (--prior).</source>
        <translation>Dziennik ma ustaloną żeglugę tylko przy tylu prędkościach wiatru: {}, i tylu kątach: {}; biegunowa potrzebuje po dwóch: podaj więcej dzienników albo biegunową wyjściową (--prior).</translation>
    </message>
    <message>
        <source>The log tells no magnetic variation.</source>
        <translation>Dziennik nie podaje deklinacji magnetycznej.</translation>
    </message>
    <message>
        <source>The log {} cannot be read: {}.</source>
        <translation>Nie można odczytać dziennika {}: {}.</translation>
    </message>
    <message>
        <source>The log&apos;s column {} has the shape {} where there are {} times; give columns of one length.</source>
        <translation>Kolumna {} dziennika ma kształt {}, a chwil jest {}; podaj kolumny jednej długości.</translation>
    </message>
    <message>
        <source>The log&apos;s first line names no column of times; a header such as time;stw;twa;tws is needed.</source>
        <translation>Pierwszy wiersz dziennika nie nazywa kolumny czasu; potrzebny jest nagłówek, np. time;stw;twa;tws.</translation>
    </message>
    <message>
        <source>The logs have {} means of {} s of steady sailing, {} are needed; of {} means {}.</source>
        <translation>Dzienniki mają {} średnich po {} s ustalonej żeglugi, potrzeba {}; ze średnich w liczbie {}: {}.</translation>
    </message>
    <message>
        <source>The mean is without {}: {}.</source>
        <translation>Średnia jest bez {}: {}.</translation>
    </message>
    <message>
        <source>The package global-land-mask is not installed; install SeaCruise again with pip or make.</source>
        <translation>Pakiet global-land-mask nie jest zainstalowany; zainstaluj SeaCruise ponownie przez pip albo make.</translation>
    </message>
    <message>
        <source>The passage that was found cannot be sailed to its end: the yacht is becalmed under way. Leave at another time or allow the engine (--motor-below).</source>
        <translation>Znalezionej trasy nie da się przepłynąć do końca: jacht staje w ciszy w drodze. Wyjdź o innej porze albo zezwól na silnik (--motor-below).</translation>
    </message>
    <message>
        <source>The passage touches the closed zone {}.</source>
        <translation>Trasa dotyka zamkniętej strefy {}.</translation>
    </message>
    <message>
        <source>The passage would end at {} UTC, after the forecast, which ends at {} UTC; leave earlier, choose a longer forecast, or let the last wind be held (--beyond hold) or fade (--beyond fade).</source>
        <translation>Trasa skończyłaby się {} UTC, po prognozie, która kończy się {} UTC; wyjdź wcześniej, wybierz dłuższą prognozę albo pozwól utrzymać ostatni wiatr (--beyond hold) lub go wygasić (--beyond fade).</translation>
    </message>
    <message>
        <source>The passage {} {} nm from {}, at the nearest water of the chart that is connected with the open sea.</source>
        <translation>Trasa {} {} Mm od punktu {}, na najbliższej wodzie mapy połączonej z otwartym morzem.</translation>
    </message>
    <message>
        <source>The picture {} must end in .png, .pdf or .svg; give another name.</source>
        <translation>Nazwa rysunku {} musi kończyć się na .png, .pdf lub .svg; podaj inną nazwę.</translation>
    </message>
    <message>
        <source>The picture {} shows one yacht, not {}; use polar or flat to compare.</source>
        <translation>Rysunek {} pokazuje jeden jacht, a nie {}; do porównania użyj polar lub flat.</translation>
    </message>
    <message>
        <source>The points of a log need one wind speed, one angle and one boat speed each.</source>
        <translation>Punkty dziennika wymagają po jednej prędkości wiatru, jednym kącie i jednej prędkości jachtu.</translation>
    </message>
    <message>
        <source>The points of {} cannot be used: {}.</source>
        <translation>Punktów jachtu {} nie można użyć: {}.</translation>
    </message>
    <message>
        <source>The polar file {} cannot be read: {}.</source>
        <translation>Nie można odczytać pliku biegunowej {}: {}.</translation>
    </message>
    <message>
        <source>The polar of {} cannot be used: {}.</source>
        <translation>Biegunowej jachtu {} nie można użyć: {}.</translation>
    </message>
    <message>
        <source>The polar to update has other wind speeds or angles than the fit; fit on its own.</source>
        <translation>Uzupełniana biegunowa ma inne prędkości wiatru lub kąty niż dopasowanie; dopasuj osobno.</translation>
    </message>
    <message>
        <source>The polygon of {} has points that are not longitude and latitude.</source>
        <translation>Wielokąt {} ma punkty, które nie są długością i szerokością geograficzną.</translation>
    </message>
    <message>
        <source>The position {} has 60 minutes or seconds, or more; check the figures.</source>
        <translation>Pozycja {} ma 60 lub więcej minut albo sekund; sprawdź liczby.</translation>
    </message>
    <message>
        <source>The position {} is not on the earth: latitude first, -90 to 90, then longitude, -180 to 180.</source>
        <translation>Pozycja {} nie leży na Ziemi: najpierw szerokość, od -90 do 90, potem długość, od -180 do 180.</translation>
    </message>
    <message>
        <source>The proxy of this network asks for a password; set it in HTTPS_PROXY.</source>
        <translation>Serwer pośredniczący tej sieci wymaga hasła; ustaw je w HTTPS_PROXY.</translation>
    </message>
    <message>
        <source>The proxy of this network does not answer; check HTTPS_PROXY.</source>
        <translation>Serwer pośredniczący tej sieci nie odpowiada; sprawdź HTTPS_PROXY.</translation>
    </message>
    <message>
        <source>The saved passage has a leg without a course; save it again.</source>
        <translation>Zapisana trasa ma odcinek bez kursu; zapisz ją ponownie.</translation>
    </message>
    <message>
        <source>The saved passage has no waypoints with rising times; save it again with &apos;seacruise plan --format json&apos;.</source>
        <translation>Zapisana trasa nie ma punktów o rosnących czasach; zapisz ją ponownie poleceniem „seacruise plan --format json”.</translation>
    </message>
    <message>
        <source>The saved passage {} is damaged; delete it and plan it again.</source>
        <translation>Zapisana trasa {} jest uszkodzona; usuń ją i zaplanuj od nowa.</translation>
    </message>
    <message>
        <source>The system&apos;s keychain would not let go of the key; it is unused until SeaCruise starts again. Remove the entry &apos;seacruise&apos; with the system&apos;s own program.</source>
        <translation>Systemowy pęk kluczy nie chce oddać klucza; do ponownego uruchomienia SeaCruise nie jest używany. Usuń wpis „seacruise” programem systemowym.</translation>
    </message>
    <message>
        <source>The weather could not be fetched ({}).</source>
        <translation>Nie udało się pobrać pogody ({}).</translation>
    </message>
    <message>
        <source>The weather file {} cannot be read: {}.</source>
        <translation>Nie można odczytać pliku pogody {}: {}.</translation>
    </message>
    <message>
        <source>The weather file {} cannot be used: {}.</source>
        <translation>Nie można użyć pliku pogody {}: {}.</translation>
    </message>
    <message>
        <source>The weather file {} is damaged ({}); download it again.</source>
        <translation>Plik pogody {} jest uszkodzony ({}); pobierz go jeszcze raz.</translation>
    </message>
    <message>
        <source>The weather file {} is damaged: the library that reads it gave up; download it again or choose another file.</source>
        <translation>Plik pogody {} jest uszkodzony: biblioteka, która go czyta, poddała się; pobierz go jeszcze raz albo wybierz inny plik.</translation>
    </message>
    <message>
        <source>The weather file {} is too large for this computer&apos;s memory.</source>
        <translation>Plik pogody {} jest za duży dla pamięci tego komputera.</translation>
    </message>
    <message>
        <source>The weather file {} takes longer than {} min to read; cut it to the area of the passage.</source>
        <translation>Odczyt pliku pogody {} trwa dłużej niż {} min; przytnij go do obszaru trasy.</translation>
    </message>
    <message>
        <source>The weather service sent more than {} MB; that is no forecast.</source>
        <translation>Usługa pogodowa przysłała ponad {} MB; to nie jest prognoza.</translation>
    </message>
    <message>
        <source>The wind ({}) does not reach {} ({}); choose a forecast that covers both ports.</source>
        <translation>Wiatr ({}) nie sięga punktu {} ({}); wybierz prognozę, która obejmuje oba porty.</translation>
    </message>
    <message>
        <source>The wind ({}) is no ensemble; choose a forecast with members.</source>
        <translation>Wiatr ({}) nie jest wiązką; wybierz prognozę z członami.</translation>
    </message>
    <message>
        <source>The wind is from an answer {} h old.</source>
        <translation>Dane o wietrze są sprzed {} h.</translation>
    </message>
    <message>
        <source>The wind is from {}, {} h old{}.</source>
        <translation>Wiatr pochodzi z {}, sprzed {} h{}.</translation>
    </message>
    <message>
        <source>The wind is that at {} m; there is none at 10 m.</source>
        <translation>To wiatr na wysokości {} m; na 10 m go nie ma.</translation>
    </message>
    <message>
        <source>The window cannot open: no font is installed; on Debian or Ubuntu: apt-get install fonts-dejavu-core.</source>
        <translation>Okno nie może się otworzyć: nie zainstalowano żadnej czcionki; w Debianie lub Ubuntu: apt-get install fonts-dejavu-core.</translation>
    </message>
    <message>
        <source>The yacht is becalmed: with this wind she never arrives. Leave at another time, choose another forecast, or allow the engine (--motor-below).</source>
        <translation>Jacht stoi w ciszy: przy tym wietrze nigdy nie dopłynie. Wyjdź o innej porze, wybierz inną prognozę albo zezwól na silnik (--motor-below).</translation>
    </message>
    <message>
        <source>The zone file {} cannot be read: {}.</source>
        <translation>Nie można odczytać pliku stref {}: {}.</translation>
    </message>
    <message>
        <source>The zone file {} holds no GeoJSON features; export the zones as GeoJSON.</source>
        <translation>Plik stref {} nie zawiera obiektów GeoJSON; wyeksportuj strefy jako GeoJSON.</translation>
    </message>
    <message>
        <source>The zone file {} is not GeoJSON of up to {} MB; export the zones so.</source>
        <translation>Plik stref {} nie jest plikiem GeoJSON o rozmiarze do {} MB; wyeksportuj strefy w ten sposób.</translation>
    </message>
    <message>
        <source>The {} cannot be written to {}: {}.</source>
        <translation>Nie można zapisać ({}) do {}: {}.</translation>
    </message>
    <message>
        <source>The {} from {} cannot be used: {}.</source>
        <translation>Nie można użyć danych ({}) z {}: {}.</translation>
    </message>
    <message>
        <source>The {} in the file is not used: {}.</source>
        <translation>Dane z pliku ({}) nie są używane: {}.</translation>
    </message>
    <message>
        <source>The {} of the file do not reach the area of the passage.</source>
        <translation>Dane z pliku ({}) nie sięgają obszaru trasy.</translation>
    </message>
    <message>
        <source>The {} of the file end at {} UTC; the last are held.</source>
        <translation>Dane z pliku ({}) kończą się {} UTC; ostatnie są utrzymane.</translation>
    </message>
    <message>
        <source>The {} {} cannot be read: {}.</source>
        <translation>Nie można odczytać ({}) {}: {}.</translation>
    </message>
    <message>
        <source>There are no {} with it.</source>
        <translation>Brak w niej: {}.</translation>
    </message>
    <message>
        <source>There are {} weights for {} forecasts; give one weight for each.</source>
        <translation>Liczba wag: {}, liczba prognoz: {}; podaj po jednej wadze na prognozę.</translation>
    </message>
    <message>
        <source>There is already a polar file {} of yours; rename one of them.</source>
        <translation>Masz już plik biegunowej {}; zmień nazwę jednego z nich.</translation>
    </message>
    <message>
        <source>There is no forecast or file {}; {}.</source>
        <translation>Nie ma prognozy ani pliku {}; {}.</translation>
    </message>
    <message>
        <source>There is no forecast to average; name at least one.</source>
        <translation>Nie ma prognozy do uśrednienia; podaj co najmniej jedną.</translation>
    </message>
    <message>
        <source>There is no list of landmarks {}; check the name and the folder.</source>
        <translation>Nie ma listy znaków {}; sprawdź nazwę i folder.</translation>
    </message>
    <message>
        <source>There is no list of points {}; check the name and the folder.</source>
        <translation>Nie ma listy punktów {}; sprawdź nazwę i folder.</translation>
    </message>
    <message>
        <source>There is no list of ports {}; check the name and the folder.</source>
        <translation>Nie ma listy portów {}; sprawdź nazwę i folder.</translation>
    </message>
    <message>
        <source>There is no log {}; check the name and the folder.</source>
        <translation>Nie ma dziennika {}; sprawdź nazwę i folder.</translation>
    </message>
    <message>
        <source>There is no picture format {}; choose one of {}.</source>
        <translation>Nie ma formatu rysunku {}; wybierz jeden z: {}.</translation>
    </message>
    <message>
        <source>There is no picture {} of a polar; choose one of {}.</source>
        <translation>Nie ma rysunku biegunowej {}; wybierz jeden z: {}.</translation>
    </message>
    <message>
        <source>There is no polar file {}; check the name and the folder.</source>
        <translation>Nie ma pliku biegunowej {}; sprawdź nazwę i folder.</translation>
    </message>
    <message>
        <source>There is no polar format {}; choose one of {}.</source>
        <translation>Nie ma formatu biegunowej {}; wybierz jeden z: {}.</translation>
    </message>
    <message>
        <source>There is no port {}: {}</source>
        <translation>Nie ma portu {}: {}</translation>
    </message>
    <message>
        <source>There is no port {}; see the list of ports, or give a position such as 54.5,18.6.</source>
        <translation>Nie ma portu {}; zobacz listę portów albo podaj pozycję, np. 54.5,18.6.</translation>
    </message>
    <message>
        <source>There is no way by water between the two ports in the area searched; choose other ports, or check that both lie on the same sea.</source>
        <translation>Na przeszukanym obszarze nie ma drogi wodnej między tymi portami; wybierz inne porty albo sprawdź, czy oba leżą nad tym samym morzem.</translation>
    </message>
    <message>
        <source>There is no way by water that keeps {} nm off every shore; allow less clearance (--shore-clearance) or choose other ports.</source>
        <translation>Nie ma drogi wodnej, która trzyma się {} Mm od każdego brzegu; zmniejsz odległość (--shore-clearance) albo wybierz inne porty.</translation>
    </message>
    <message>
        <source>There is no yacht {}: {}</source>
        <translation>Nie ma jachtu {}: {}</translation>
    </message>
    <message>
        <source>There is no yacht {}; see the list of yachts, or give the path of a polar file.</source>
        <translation>Nie ma jachtu {}; zobacz listę jachtów albo podaj ścieżkę pliku biegunowej.</translation>
    </message>
    <message>
        <source>There is no {} {}; check the name and the folder.</source>
        <translation>Nie znaleziono ({}) {}; sprawdź nazwę i folder.</translation>
    </message>
    <message>
        <source>There is nothing to compare; give at least one departure.</source>
        <translation>Nie ma czego porównywać; podaj co najmniej jedno wyjście.</translation>
    </message>
    <message>
        <source>This is no key: it is empty or has characters that no key has; copy it again without spaces.</source>
        <translation>To nie jest klucz: jest pusty albo ma znaki, których żaden klucz nie ma; skopiuj go jeszcze raz, bez spacji.</translation>
    </message>
    <message>
        <source>This passage is no longer saved; it was deleted by another window.</source>
        <translation>Ta trasa nie jest już zapisana; usunięto ją w innym oknie.</translation>
    </message>
    <message>
        <source>This yacht</source>
        <translation>Ten jacht</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>W drodze</translation>
    </message>
    <message>
        <source>Used under your own contract with Storm Glass.</source>
        <translation>Używane na podstawie twojej własnej umowy ze Storm Glass.</translation>
    </message>
    <message>
        <source>Virtual Regatta</source>
        <translation>Virtual Regatta</translation>
    </message>
    <message>
        <source>Waves and current are from {} h ago.</source>
        <translation>Fale i prąd są sprzed {} h.</translation>
    </message>
    <message>
        <source>Waves are known until {}; the last ones are held.</source>
        <translation>Fale są znane do {}; ostatnie są utrzymane.</translation>
    </message>
    <message>
        <source>Ways to or from {} are sailed in part in the last known wind, held beyond the end of the forecast.</source>
        <translation>Drogi do {} lub z powrotem płynie się częściowo na ostatnim znanym wietrze, utrzymanym po końcu prognozy.</translation>
    </message>
    <message>
        <source>Weather data by MET Norway (CC BY 4.0).</source>
        <translation>Dane pogodowe: MET Norway (CC BY 4.0).</translation>
    </message>
    <message>
        <source>Weather data by Open-Meteo.com (CC BY 4.0); its free service is for non-commercial use.</source>
        <translation>Dane pogodowe: Open-Meteo.com (CC BY 4.0); bezpłatna usługa jest do użytku niekomercyjnego.</translation>
    </message>
    <message>
        <source>Weighing time against changes of course</source>
        <translation>Ważenie czasu względem zmian kursu</translation>
    </message>
    <message>
        <source>Wind from Open-Meteo, because no Storm Glass key is set</source>
        <translation>Wiatr z Open-Meteo, bo nie ma klucza Storm Glass</translation>
    </message>
    <message>
        <source>Wind from Storm Glass, because a key is set</source>
        <translation>Wiatr ze Storm Glass, bo klucz jest ustawiony</translation>
    </message>
    <message>
        <source>Wind, gusts or waves come too close to what you allow on every way that was found; leave at another time or raise the limit.</source>
        <translation>Na każdej znalezionej drodze wiatr, porywy lub fale są zbyt blisko twoich ograniczeń; wyjdź o innej porze albo podnieś ograniczenie.</translation>
    </message>
    <message>
        <source>Your polar folder {} cannot be made: {}; make room there.</source>
        <translation>Nie można utworzyć twojego folderu biegunowych {}: {}; zwolnij tam miejsce.</translation>
    </message>
    <message>
        <source>Zones that are kept clear of: {}.</source>
        <translation>Omijane strefy: {}.</translation>
    </message>
    <message>
        <source>a boat speed is negative or not finite</source>
        <translation>prędkość jachtu jest ujemna lub nieskończona</translation>
    </message>
    <message>
        <source>a generated week from today; not a forecast</source>
        <translation>wygenerowany tydzień od dziś; to nie prognoza</translation>
    </message>
    <message>
        <source>a grid of the kind {} with {} values cannot be read</source>
        <translation>siatki rodzaju {} o liczbie wartości {} nie można odczytać</translation>
    </message>
    <message>
        <source>a line of figures ({})</source>
        <translation>wiersz liczb ({})</translation>
    </message>
    <message>
        <source>a rectangular lattice has {} courses, not {}</source>
        <translation>siatka prostokątna ma {} kursów, a nie {}</translation>
    </message>
    <message>
        <source>a time has no time zone</source>
        <translation>chwila nie ma strefy czasowej</translation>
    </message>
    <message>
        <source>a triangular lattice has {} courses, not {}</source>
        <translation>siatka trójkątna ma {} kursów, a nie {}</translation>
    </message>
    <message>
        <source>a wind or a boat speed is negative</source>
        <translation>prędkość wiatru lub jachtu jest ujemna</translation>
    </message>
    <message>
        <source>a wind speed has no figure at any angle</source>
        <translation>jedna z prędkości wiatru nie ma liczby przy żadnym kącie</translation>
    </message>
    <message>
        <source>after a tack or gybe</source>
        <translation>po zwrocie</translation>
    </message>
    <message>
        <source>an angle is not within 0 and 180 degrees</source>
        <translation>kąt nie leży między 0 a 180 stopni</translation>
    </message>
    <message>
        <source>and</source>
        <translation>i</translation>
    </message>
    <message>
        <source>as far as known</source>
        <translation>o ile wiadomo</translation>
    </message>
    <message>
        <source>begins</source>
        <translation>zaczyna się</translation>
    </message>
    <message>
        <source>beside a gap</source>
        <translation>obok przerwy</translation>
    </message>
    <message>
        <source>boat speed</source>
        <translation>prędkość jachtu</translation>
    </message>
    <message>
        <source>both</source>
        <translation>oba</translation>
    </message>
    <message>
        <source>by the service&apos;s own count</source>
        <translation>według licznika usługi</translation>
    </message>
    <message>
        <source>cannot be used ({})</source>
        <translation>nie może być użyty ({})</translation>
    </message>
    <message>
        <source>cannot be written: the disk is full</source>
        <translation>nie może być zapisany: dysk jest pełny</translation>
    </message>
    <message>
        <source>cannot be written; set SEACRUISE_HOME to a folder of yours</source>
        <translation>nie może być zapisany; ustaw SEACRUISE_HOME na własny folder</translation>
    </message>
    <message>
        <source>choose {}, or give the path of a GRIB or NetCDF file</source>
        <translation>wybierz {} albo podaj ścieżkę pliku GRIB lub NetCDF</translation>
    </message>
    <message>
        <source>current</source>
        <translation>prąd</translation>
    </message>
    <message>
        <source>did you mean {} or {}?</source>
        <translation>czy chodziło o {} lub {}?</translation>
    </message>
    <message>
        <source>did you mean {}?</source>
        <translation>czy chodziło o {}?</translation>
    </message>
    <message>
        <source>east</source>
        <translation>wschód</translation>
    </message>
    <message>
        <source>ends</source>
        <translation>kończy się</translation>
    </message>
    <message>
        <source>fade</source>
        <translation>wygaszanie</translation>
    </message>
    <message>
        <source>fading to the usual</source>
        <translation>przechodzącym w średni</translation>
    </message>
    <message>
        <source>feature {} of {}</source>
        <translation>obiekt {} z {}</translation>
    </message>
    <message>
        <source>fitted to {} steady means of {} s from {}</source>
        <translation>dopasowano do {} ustalonych średnich po {} s z {}</translation>
    </message>
    <message>
        <source>gust</source>
        <translation>poryw</translation>
    </message>
    <message>
        <source>gusts</source>
        <translation>porywy</translation>
    </message>
    <message>
        <source>has</source>
        <translation>ich</translation>
    </message>
    <message>
        <source>has no request left</source>
        <translation>nie ma już zapytań</translation>
    </message>
    <message>
        <source>has only {} left</source>
        <translation>ma już tylko tyle zapytań: {}</translation>
    </message>
    <message>
        <source>have</source>
        <translation>ich</translation>
    </message>
    <message>
        <source>held</source>
        <translation>utrzymanym</translation>
    </message>
    <message>
        <source>held back</source>
        <translation>odłożone</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>utrzymanie</translation>
    </message>
    <message>
        <source>in a minute</source>
        <translation>za minutę</translation>
    </message>
    <message>
        <source>in some minutes</source>
        <translation>za kilka minut</translation>
    </message>
    <message>
        <source>in {} minutes</source>
        <translation>za {} min</translation>
    </message>
    <message>
        <source>is damaged; move it away and SeaCruise makes a new one</source>
        <translation>jest uszkodzony; przenieś go, a SeaCruise utworzy nowy</translation>
    </message>
    <message>
        <source>is in use by another program; close that and try again</source>
        <translation>jest używany przez inny program; zamknij go i spróbuj ponownie</translation>
    </message>
    <message>
        <source>it does not say why</source>
        <translation>nie podaje przyczyny</translation>
    </message>
    <message>
        <source>it has latitudes beyond the poles</source>
        <translation>ma szerokości geograficzne poza biegunami</translation>
    </message>
    <message>
        <source>it has no time axis (&apos;hours since ...&apos;)</source>
        <translation>nie ma osi czasu („hours since ...”)</translation>
    </message>
    <message>
        <source>it has no wind speeds or no wind angles</source>
        <translation>nie ma prędkości wiatru lub kątów wiatru</translation>
    </message>
    <message>
        <source>it has no {} axis</source>
        <translation>brakuje mu osi {}</translation>
    </message>
    <message>
        <source>it has values that are missing or above {} {}</source>
        <translation>ma wartości, których brakuje albo które przekraczają {} {}</translation>
    </message>
    <message>
        <source>it has variables of more than {} million values</source>
        <translation>ma zmienne o ponad {} milionach wartości</translation>
    </message>
    <message>
        <source>it holds only one of the two components of the wind</source>
        <translation>zawiera tylko jedną z dwóch składowych wiatru</translation>
    </message>
    <message>
        <source>it holds sea currents and no wind; give it as the current instead</source>
        <translation>zawiera prądy morskie, a nie wiatr; podaj go jako prąd</translation>
    </message>
    <message>
        <source>it is compressed, and damaged or cut off</source>
        <translation>jest skompresowany i uszkodzony albo ucięty</translation>
    </message>
    <message>
        <source>it is damaged ({})</source>
        <translation>jest uszkodzony ({})</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>jest pusty</translation>
    </message>
    <message>
        <source>it is larger than {} MB when expanded</source>
        <translation>po rozpakowaniu jest większy niż {} MB</translation>
    </message>
    <message>
        <source>it is larger than {} MB; cut it to the area of the passage</source>
        <translation>jest większy niż {} MB; przytnij go do obszaru trasy</translation>
    </message>
    <message>
        <source>it is neither GRIB nor NetCDF</source>
        <translation>nie jest to ani GRIB, ani NetCDF</translation>
    </message>
    <message>
        <source>it is not a GRIB file, or nothing of it arrived</source>
        <translation>nie jest to plik GRIB albo nic z niego nie dotarło</translation>
    </message>
    <message>
        <source>it is not a NetCDF file, or it is damaged</source>
        <translation>nie jest to plik NetCDF albo jest uszkodzony</translation>
    </message>
    <message>
        <source>it names the parameter {}</source>
        <translation>wymienia parametr {}</translation>
    </message>
    <message>
        <source>its area</source>
        <translation>jego obszar</translation>
    </message>
    <message>
        <source>its certificate has expired</source>
        <translation>jego certyfikat wygasł</translation>
    </message>
    <message>
        <source>its certificate is for another address</source>
        <translation>jego certyfikat jest dla innego adresu</translation>
    </message>
    <message>
        <source>its certificate is for another name</source>
        <translation>jego certyfikat jest dla innej nazwy</translation>
    </message>
    <message>
        <source>its certificate is not valid</source>
        <translation>jego certyfikat jest nieważny</translation>
    </message>
    <message>
        <source>its certificate is self-signed</source>
        <translation>jego certyfikat jest podpisany przez niego samego</translation>
    </message>
    <message>
        <source>its certificate is signed by nobody this computer trusts</source>
        <translation>jego certyfikatu nie podpisał nikt, komu ten komputer ufa</translation>
    </message>
    <message>
        <source>its current does not reach the area of the passage</source>
        <translation>jego prąd nie sięga obszaru trasy</translation>
    </message>
    <message>
        <source>its current is missing (masked) all over the area of the passage</source>
        <translation>na całym obszarze trasy brakuje jego prądu (zamaskowany)</translation>
    </message>
    <message>
        <source>its current runs at {} m/s, which no water does</source>
        <translation>jego prąd płynie {} m/s, czego żadna woda nie robi</translation>
    </message>
    <message>
        <source>its grid does not reach the area of the passage</source>
        <translation>jego siatka nie sięga obszaru trasy</translation>
    </message>
    <message>
        <source>its grid is {}, its axes say {}</source>
        <translation>jego siatka to {}, a jego osie mówią {}</translation>
    </message>
    <message>
        <source>its members are not on the axes of their mean</source>
        <translation>jego człony nie leżą na osiach ich średniej</translation>
    </message>
    <message>
        <source>its schema is {}, not {}</source>
        <translation>jego schemat to {}, a nie {}</translation>
    </message>
    <message>
        <source>its tables do not fit its axes</source>
        <translation>jego tabele nie pasują do osi</translation>
    </message>
    <message>
        <source>its times are not times</source>
        <translation>jego czasy nie są czasami</translation>
    </message>
    <message>
        <source>its wind angles must increase within 0 and 180 degrees</source>
        <translation>jego kąty wiatru muszą rosnąć między 0 a 180 stopni</translation>
    </message>
    <message>
        <source>its wind blows above {} m/s, which no wind does</source>
        <translation>jego wiatr wieje powyżej {} m/s, czego żaden wiatr nie robi</translation>
    </message>
    <message>
        <source>its wind is missing (masked) around {}, as in files that leave out land and inland seas; choose another forecast</source>
        <translation>brakuje jego wiatru (zamaskowany) w okolicy: {}, jak w plikach pomijających ląd i morza śródlądowe; wybierz inną prognozę</translation>
    </message>
    <message>
        <source>its wind is missing (masked) over {} of {}</source>
        <translation>jego wiatru brakuje (zamaskowany): {}, {}</translation>
    </message>
    <message>
        <source>its wind is that of pressure levels aloft, and there is none at 10 m</source>
        <translation>jego wiatr pochodzi z wysokich poziomów ciśnienia, a na 10 m go nie ma</translation>
    </message>
    <message>
        <source>its wind speeds must increase from zero or more</source>
        <translation>jego prędkości wiatru muszą rosnąć od zera lub więcej</translation>
    </message>
    <message>
        <source>its {} are empty or not numbers</source>
        <translation>jego dane ({}) są puste albo nie są liczbami</translation>
    </message>
    <message>
        <source>its {} are not evenly spaced</source>
        <translation>jego dane ({}) nie są rozłożone równomiernie</translation>
    </message>
    <message>
        <source>its {} do not increase</source>
        <translation>jego dane ({}) nie rosną</translation>
    </message>
    <message>
        <source>its {} figures do not fit {} angles and {} wind speeds</source>
        <translation>jego liczby ({}) nie pasują do {} kątów i {} prędkości wiatru</translation>
    </message>
    <message>
        <source>its {} is given in {}, not in {}</source>
        <translation>jego wielkość ({}) podano w {}, a nie w {}</translation>
    </message>
    <message>
        <source>line 1: a polar file that the boat names is itself a boat</source>
        <translation>wiersz 1: plik biegunowej, który wymienia jednostka, sam jest jednostką</translation>
    </message>
    <message>
        <source>line 1: a polar needs figures at two wind speeds and two angles or more{}</source>
        <translation>wiersz 1: biegunowa wymaga liczb przy co najmniej dwóch prędkościach wiatru i dwóch kątach{}</translation>
    </message>
    <message>
        <source>line 1: a polar needs points at two wind speeds and two angles or more</source>
        <translation>wiersz 1: biegunowa wymaga punktów przy co najmniej dwóch prędkościach wiatru i dwóch kątach</translation>
    </message>
    <message>
        <source>line 1: all boat speeds are zero</source>
        <translation>wiersz 1: wszystkie prędkości jachtu są równe zeru</translation>
    </message>
    <message>
        <source>line 1: all boat speeds are zero{}</source>
        <translation>wiersz 1: wszystkie prędkości jachtu są równe zeru{}</translation>
    </message>
    <message>
        <source>line 1: the boat&apos;s polar file {} does not lie beside it</source>
        <translation>wiersz 1: plik biegunowej {} tej jednostki nie leży obok niego</translation>
    </message>
    <message>
        <source>line 1: there are only comments and no figures</source>
        <translation>wiersz 1: są tylko komentarze, a nie ma liczb</translation>
    </message>
    <message>
        <source>line 1: there is a header but no points</source>
        <translation>wiersz 1: jest nagłówek, ale nie ma punktów</translation>
    </message>
    <message>
        <source>line 1: this JSON is nested too deeply or has a number without end</source>
        <translation>wiersz 1: ten JSON jest zbyt głęboko zagnieżdżony albo ma liczbę bez końca</translation>
    </message>
    <message>
        <source>line 1: this JSON is no polar of SeaCruise (boat_speed_kn), ORC (vpp) or Virtual Regatta (sail)</source>
        <translation>wiersz 1: ten JSON nie jest biegunową SeaCruise (boat_speed_kn), ORC (vpp) ani Virtual Regatta (sail)</translation>
    </message>
    <message>
        <source>line 1: this XML declares things of its own; that is no OpenCPN boat</source>
        <translation>wiersz 1: ten XML ma własne deklaracje; to nie jest jednostka OpenCPN</translation>
    </message>
    <message>
        <source>line 1: this XML is no OpenCPN boat with a polar file</source>
        <translation>wiersz 1: ten XML nie jest jednostką OpenCPN z plikiem biegunowej</translation>
    </message>
    <message>
        <source>line 1: this is no list of points, which begins with TWS,TWA,BSP</source>
        <translation>wiersz 1: to nie jest lista punktów, która zaczyna się od TWS,TWA,BSP</translation>
    </message>
    <message>
        <source>line 1: two sails have the name {}</source>
        <translation>wiersz 1: dwa żagle mają nazwę {}</translation>
    </message>
    <message>
        <source>line 1: {} is not a number</source>
        <translation>wiersz 1: {} nie jest liczbą</translation>
    </message>
    <message>
        <source>line 1: {} sails are more than a yacht carries</source>
        <translation>wiersz 1: tyle żagli ({}) nie nosi żaden jacht</translation>
    </message>
    <message>
        <source>line 1: {} wind speeds and {} angles are more than a polar has</source>
        <translation>wiersz 1: {} prędkości wiatru i {} kątów to więcej, niż ma biegunowa</translation>
    </message>
    <message>
        <source>line {}, cell {}</source>
        <translation>wiersz {}, komórka {}</translation>
    </message>
    <message>
        <source>line {}, column {}: this is not JSON</source>
        <translation>wiersz {}, kolumna {}: to nie jest JSON</translation>
    </message>
    <message>
        <source>line {}: after the wind speed there must be pairs of angle and boat speed</source>
        <translation>wiersz {}: po prędkości wiatru muszą następować pary kąta i prędkości jachtu</translation>
    </message>
    <message>
        <source>line {}: an angle is there twice</source>
        <translation>wiersz {}: ten sam kąt jest dwa razy</translation>
    </message>
    <message>
        <source>line {}: the angles and boat speeds are missing</source>
        <translation>wiersz {}: brakuje kątów i prędkości jachtu</translation>
    </message>
    <message>
        <source>line {}: the file ends where {} should follow</source>
        <translation>wiersz {}: plik kończy się tam, gdzie powinno następować: {}</translation>
    </message>
    <message>
        <source>line {}: the header of {} is missing</source>
        <translation>wiersz {}: brakuje nagłówka: {}</translation>
    </message>
    <message>
        <source>line {}: the header with the wind speeds is missing, such as twa/tws;6;8;10</source>
        <translation>wiersz {}: brakuje nagłówka z prędkościami wiatru, np. twa/tws;6;8;10</translation>
    </message>
    <message>
        <source>line {}: the quotation marks do not match</source>
        <translation>wiersz {}: cudzysłowy się nie zgadzają</translation>
    </message>
    <message>
        <source>line {}: the row of angles that this VMG belongs to is missing</source>
        <translation>wiersz {}: brakuje wiersza kątów, do którego należy to VMG</translation>
    </message>
    <message>
        <source>line {}: the sails are in files of their own; name one of those</source>
        <translation>wiersz {}: żagle są we własnych plikach; podaj jeden z nich</translation>
    </message>
    <message>
        <source>line {}: there is a header but no rows of boat speeds</source>
        <translation>wiersz {}: jest nagłówek, ale nie ma wierszy prędkości jachtu</translation>
    </message>
    <message>
        <source>line {}: there is only one wind speed; a polar needs two or more</source>
        <translation>wiersz {}: jest tylko jedna prędkość wiatru; biegunowa wymaga co najmniej dwóch</translation>
    </message>
    <message>
        <source>line {}: this is no header of a polar, such as twa/tws;6;8;10</source>
        <translation>wiersz {}: to nie jest nagłówek biegunowej, np. twa/tws;6;8;10</translation>
    </message>
    <message>
        <source>line {}: this is not XML that can be read</source>
        <translation>wiersz {}: to nie jest XML, który da się odczytać</translation>
    </message>
    <message>
        <source>line {}: wind speed, wind angle and boat speed are needed</source>
        <translation>wiersz {}: potrzebne są prędkość wiatru, kąt wiatru i prędkość jachtu</translation>
    </message>
    <message>
        <source>line {}: {} figures for {} wind speeds</source>
        <translation>wiersz {}: liczb jest {}, a prędkości wiatru {}</translation>
    </message>
    <message>
        <source>line {}: {} figures where the header has {} {}</source>
        <translation>wiersz {}: liczb jest {}, a nagłówek ma {} ({})</translation>
    </message>
    <message>
        <source>line {}: {} should be here</source>
        <translation>wiersz {}: tu powinno być: {}</translation>
    </message>
    <message>
        <source>list of landmarks</source>
        <translation>lista znaków</translation>
    </message>
    <message>
        <source>list of points</source>
        <translation>lista punktów</translation>
    </message>
    <message>
        <source>list of ports</source>
        <translation>lista portów</translation>
    </message>
    <message>
        <source>log against receiver</source>
        <translation>log względem odbiornika</translation>
    </message>
    <message>
        <source>members</source>
        <translation>człony</translation>
    </message>
    <message>
        <source>missing wind or speed</source>
        <translation>bez wiatru lub prędkości</translation>
    </message>
    <message>
        <source>neither gusts nor waves</source>
        <translation>nie ma ani porywów, ani fal</translation>
    </message>
    <message>
        <source>no gusts</source>
        <translation>nie ma porywów</translation>
    </message>
    <message>
        <source>no key needed; nine days of wind and gusts</source>
        <translation>klucz niepotrzebny; dziewięć dni wiatru i porywów</translation>
    </message>
    <message>
        <source>no key needed; ten days of wind, gusts, waves and current</source>
        <translation>klucz niepotrzebny; dziesięć dni wiatru, porywów, fal i prądu</translation>
    </message>
    <message>
        <source>no key needed; ten days, 51 members of ECMWF</source>
        <translation>klucz niepotrzebny; dziesięć dni, 51 członów ECMWF</translation>
    </message>
    <message>
        <source>no safe TLS connection</source>
        <translation>brak bezpiecznego połączenia TLS</translation>
    </message>
    <message>
        <source>no waves</source>
        <translation>nie ma fal</translation>
    </message>
    <message>
        <source>no {}</source>
        <translation>brak: {}</translation>
    </message>
    <message>
        <source>none had wind and speed</source>
        <translation>żadna nie miała wiatru i prędkości</translation>
    </message>
    <message>
        <source>none of its variables is a current (uo and vo, or eastward_sea_water_velocity and northward_sea_water_velocity)</source>
        <translation>żadna z jego zmiennych nie jest prądem (uo i vo albo eastward_sea_water_velocity i northward_sea_water_velocity)</translation>
    </message>
    <message>
        <source>none of its variables is the wind at 10 m (u10 and v10, or eastward_wind and northward_wind)</source>
        <translation>żadna z jego zmiennych nie jest wiatrem na 10 m (u10 i v10 albo eastward_wind i northward_wind)</translation>
    </message>
    <message>
        <source>none of its {} messages is a sea current</source>
        <translation>żaden z jego komunikatów ({}) nie jest prądem morskim</translation>
    </message>
    <message>
        <source>none of its {} messages is wind at 10 m</source>
        <translation>żaden z jego komunikatów ({}) nie jest wiatrem na 10 m</translation>
    </message>
    <message>
        <source>north</source>
        <translation>północ</translation>
    </message>
    <message>
        <source>not a forecast</source>
        <translation>to nie prognoza</translation>
    </message>
    <message>
        <source>not a record of ours ({})</source>
        <translation>nie jest to nasz zapis ({})</translation>
    </message>
    <message>
        <source>number {}</source>
        <translation>numer {}</translation>
    </message>
    <message>
        <source>of other kinds</source>
        <translation>innych rodzajów</translation>
    </message>
    <message>
        <source>of other vessels</source>
        <translation>innych jednostek</translation>
    </message>
    <message>
        <source>one is not finite</source>
        <translation>jedna z wartości nie jest skończona</translation>
    </message>
    <message>
        <source>one of its messages cannot be decoded ({})</source>
        <translation>jednego z jego komunikatów nie da się zdekodować ({})</translation>
    </message>
    <message>
        <source>one of its messages is damaged</source>
        <translation>jeden z jego komunikatów jest uszkodzony</translation>
    </message>
    <message>
        <source>one of its messages is damaged (its grid)</source>
        <translation>jeden z jego komunikatów jest uszkodzony (siatka)</translation>
    </message>
    <message>
        <source>one of its messages is damaged (its number of values)</source>
        <translation>jeden z jego komunikatów jest uszkodzony (liczba wartości)</translation>
    </message>
    <message>
        <source>one of its messages is damaged (its unit of time)</source>
        <translation>jeden z jego komunikatów jest uszkodzony (jednostka czasu)</translation>
    </message>
    <message>
        <source>one port</source>
        <translation>jednego portu</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>rysunek</translation>
    </message>
    <message>
        <source>polar file</source>
        <translation>plik biegunowej</translation>
    </message>
    <message>
        <source>polar&apos;s figures</source>
        <translation>liczby biegunowej</translation>
    </message>
    <message>
        <source>port</source>
        <translation>lewy</translation>
    </message>
    <message>
        <source>real analyses, {} to {}</source>
        <translation>rzeczywiste analizy, od {} do {}</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>odmowa</translation>
    </message>
    <message>
        <source>sail {}, speed</source>
        <translation>żagiel {}, prędkość</translation>
    </message>
    <message>
        <source>sail: there is no sail with a boat speed above zero</source>
        <translation>żagiel: żaden żagiel nie ma prędkości jachtu większej od zera</translation>
    </message>
    <message>
        <source>south</source>
        <translation>południe</translation>
    </message>
    <message>
        <source>starboard</source>
        <translation>prawy</translation>
    </message>
    <message>
        <source>that is a folder; add a file name</source>
        <translation>to jest folder; dodaj nazwę pliku</translation>
    </message>
    <message>
        <source>the area around the passage, as in files that leave out land and inland seas; choose another forecast</source>
        <translation>obszar wokół trasy, jak w plikach pomijających ląd i morza śródlądowe; wybierz inną prognozę</translation>
    </message>
    <message>
        <source>the axes of its {} are damaged</source>
        <translation>osie wielkości {} są uszkodzone</translation>
    </message>
    <message>
        <source>the count starts again at 00:00 UTC</source>
        <translation>licznik rusza od nowa o 00:00 UTC</translation>
    </message>
    <message>
        <source>the count starts again at the next full hour</source>
        <translation>licznik rusza od nowa o najbliższej pełnej godzinie</translation>
    </message>
    <message>
        <source>the folder {} is write-protected; choose another</source>
        <translation>folder {} jest chroniony przed zapisem; wybierz inny</translation>
    </message>
    <message>
        <source>the name of a sail</source>
        <translation>nazwa żagla</translation>
    </message>
    <message>
        <source>the table</source>
        <translation>tabela</translation>
    </message>
    <message>
        <source>the wind jumps there by up to {} m/s</source>
        <translation>wiatr zmienia się tam skokowo nawet o {} m/s</translation>
    </message>
    <message>
        <source>there are no times</source>
        <translation>nie ma czasów</translation>
    </message>
    <message>
        <source>there are none</source>
        <translation>nie ma żadnych</translation>
    </message>
    <message>
        <source>there is no folder {}; create it first</source>
        <translation>nie ma folderu {}; najpierw go utwórz</translation>
    </message>
    <message>
        <source>there is no {}</source>
        <translation>brakuje: {}</translation>
    </message>
    <message>
        <source>this yacht</source>
        <translation>ten jacht</translation>
    </message>
    <message>
        <source>try again in a minute</source>
        <translation>spróbuj ponownie za minutę</translation>
    </message>
    <message>
        <source>under engine</source>
        <translation>na silniku</translation>
    </message>
    <message>
        <source>up to</source>
        <translation>do</translation>
    </message>
    <message>
        <source>wave height</source>
        <translation>wysokość fali</translation>
    </message>
    <message>
        <source>waves</source>
        <translation>fale</translation>
    </message>
    <message>
        <source>west</source>
        <translation>zachód</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>wiatr</translation>
    </message>
    <message>
        <source>wind angle</source>
        <translation>kąt wiatru</translation>
    </message>
    <message>
        <source>wind shifting</source>
        <translation>zmienny wiatr</translation>
    </message>
    <message>
        <source>wind speed</source>
        <translation>prędkość wiatru</translation>
    </message>
    <message>
        <source>wind speeds</source>
        <translation>prędkości wiatru</translation>
    </message>
    <message>
        <source>wind {} of {}</source>
        <translation>wiatr {} z {}</translation>
    </message>
    <message>
        <source>winds, angles and speeds are not of one number</source>
        <translation>wiatrów, kątów i prędkości nie jest tyle samo</translation>
    </message>
    <message>
        <source>with a wrong checksum</source>
        <translation>z błędną sumą kontrolną</translation>
    </message>
    <message>
        <source>without a checksum</source>
        <translation>bez sumy kontrolnej</translation>
    </message>
    <message>
        <source>without a time</source>
        <translation>bez czasu</translation>
    </message>
    <message>
        <source>without a valid figure</source>
        <translation>bez poprawnej liczby</translation>
    </message>
    <message>
        <source>{} a day on this plan</source>
        <translation>{} dziennie w tym planie</translation>
    </message>
    <message>
        <source>{} accelerating</source>
        <translation>{} przy zmianie prędkości</translation>
    </message>
    <message>
        <source>{} after a tack or gybe</source>
        <translation>{} po zwrocie</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} i {}</translation>
    </message>
    <message>
        <source>{} and {} other logs</source>
        <translation>{} i inne dzienniki: {}</translation>
    </message>
    <message>
        <source>{} answered for another place than the one asked; try again later.</source>
        <translation>{}: odpowiedź dla innego miejsca, niż zapytano; spróbuj później.</translation>
    </message>
    <message>
        <source>{} answered for other days than those asked; check this computer&apos;s date.</source>
        <translation>{}: odpowiedź dla innych dni, niż zapytano; sprawdź datę tego komputera.</translation>
    </message>
    <message>
        <source>{} answered for {} places where {} were asked; try again later.</source>
        <translation>{}: odpowiedź dla {} miejsc, a zapytano o {}; spróbuj później.</translation>
    </message>
    <message>
        <source>{} beside a gap</source>
        <translation>{} obok przerwy</translation>
    </message>
    <message>
        <source>{} beside the polar cannot be used ({}); remove it to start anew from the polar.</source>
        <translation>Pliku {} obok biegunowej nie można użyć ({}); usuń go, aby zacząć od nowa od biegunowej.</translation>
    </message>
    <message>
        <source>{} calm</source>
        <translation>{} w ciszy</translation>
    </message>
    <message>
        <source>{} cannot be copied to {}: {}.</source>
        <translation>Nie można skopiować {} do {}: {}.</translation>
    </message>
    <message>
        <source>{} cannot be reached; check the internet connection, or plan with practice weather.</source>
        <translation>Nie można połączyć się z {}; sprawdź połączenie z internetem albo planuj z pogodą ćwiczebną.</translation>
    </message>
    <message>
        <source>{} cannot be read: {}.</source>
        <translation>Nie można odczytać {}: {}.</translation>
    </message>
    <message>
        <source>{} cannot be used. {}</source>
        <translation>Nie można użyć {}. {}</translation>
    </message>
    <message>
        <source>{} could not prove who it is ({}), so nothing was sent; check this computer&apos;s date, or use another network.</source>
        <translation>Nie udało się potwierdzić tożsamości {} ({}), więc nic nie wysłano; sprawdź datę tego komputera albo użyj innej sieci.</translation>
    </message>
    <message>
        <source>{} covers {}</source>
        <translation>{} obejmuje {}</translation>
    </message>
    <message>
        <source>{} covers {}, and {} is outside; choose another forecast.</source>
        <translation>{} obejmuje {}, a {} leży poza tym obszarem; wybierz inną prognozę.</translation>
    </message>
    <message>
        <source>{} days</source>
        <translation>{} d</translation>
    </message>
    <message>
        <source>{} departures every {} cannot be compared; give 1 to {} of them, one minute to 30 days apart.</source>
        <translation>Nie można porównać {} wyjść co {}; podaj od 1 do {} wyjść, w odstępie od jednej minuty do 30 dni.</translation>
    </message>
    <message>
        <source>{} did not answer within {} seconds; try again, or plan with practice weather.</source>
        <translation>{} nie odpowiada od {} s; spróbuj ponownie albo planuj z pogodą ćwiczebną.</translation>
    </message>
    <message>
        <source>{} ensemble (ECMWF, mean of {} members)</source>
        <translation>{}, wiązka (ECMWF, średnia z {} członów)</translation>
    </message>
    <message>
        <source>{} ensemble (ECMWF, member {})</source>
        <translation>{}, wiązka (ECMWF, człon {})</translation>
    </message>
    <message>
        <source>{} follows {} until {}, then {}</source>
        <translation>{} opiera się na {} do {}, potem {}</translation>
    </message>
    <message>
        <source>{} forecasts from {} to {} UTC; choose a departure between them, or another forecast.</source>
        <translation>{} obejmuje czas od {} do {} UTC; wybierz wyjście w tym zakresie albo inną prognozę.</translation>
    </message>
    <message>
        <source>{} gave an answer that is not a forecast (HTTP {}); check its address.</source>
        <translation>{}: odpowiedź nie jest prognozą (HTTP {}); sprawdź adres usługi.</translation>
    </message>
    <message>
        <source>{} has a header but no ports; add lines such as Gdynia,PL,54.516,18.553.</source>
        <translation>{} ma nagłówek, ale nie ma portów; dodaj wiersze takie jak Gdynia,PL,54.516,18.553.</translation>
    </message>
    <message>
        <source>{} has answered as often as it does without payment; {}. Until then plan with practice weather or a file.</source>
        <translation>{}: wyczerpano liczbę odpowiedzi bez opłaty; {}. Do tego czasu planuj z pogodą ćwiczebną lub plikiem.</translation>
    </message>
    <message>
        <source>{} has no forecast for a place of this passage (HTTP {}).</source>
        <translation>{} nie ma prognozy dla jednego z miejsc tej trasy (HTTP {}).</translation>
    </message>
    <message>
        <source>{} has no sails; give a polar for one at least.</source>
        <translation>{} nie ma żagli; podaj biegunową co najmniej jednego.</translation>
    </message>
    <message>
        <source>{} has no water connected with the open sea within {} nm; choose a port on the coast or a position at sea.</source>
        <translation>{} nie ma w promieniu {} Mm wody połączonej z otwartym morzem; wybierz port na wybrzeżu albo pozycję na morzu.</translation>
    </message>
    <message>
        <source>{} has no wind for this area; choose another forecast.</source>
        <translation>{} nie ma wiatru dla tego obszaru; wybierz inną prognozę.</translation>
    </message>
    <message>
        <source>{} has trouble of its own (HTTP {}); try again later.</source>
        <translation>{} ma własne kłopoty (HTTP {}); spróbuj później.</translation>
    </message>
    <message>
        <source>{} has two sails named {}; rename one of them.</source>
        <translation>{} ma dwa żagle o nazwie {}; zmień nazwę jednego z nich.</translation>
    </message>
    <message>
        <source>{} has {} values for {} times</source>
        <translation>{}: wartości {}, a chwil {}</translation>
    </message>
    <message>
        <source>{} hours cannot be looked at; give more than 0 and at most {}.</source>
        <translation>Nie można rozpatrzyć {} h; podaj więcej niż 0 i najwyżej {}.</translation>
    </message>
    <message>
        <source>{} is a folder; name a {}.</source>
        <translation>{} jest folderem; wskaż plik ({}).</translation>
    </message>
    <message>
        <source>{} is asked too often by this program or network; try again in some minutes, or choose another forecast.</source>
        <translation>{}: ten program lub ta sieć pyta zbyt często; spróbuj za kilka minut albo wybierz inną prognozę.</translation>
    </message>
    <message>
        <source>{} is asked too often just now; try again {}.</source>
        <translation>{}: zapytania są teraz zbyt częste; spróbuj ponownie {}.</translation>
    </message>
    <message>
        <source>{} is both the start and the end; choose two different ports.</source>
        <translation>{} to zarazem start i cel; wybierz dwa różne porty.</translation>
    </message>
    <message>
        <source>{} is empty; choose another {}.</source>
        <translation>{} jest pusty; wybierz inny plik ({}).</translation>
    </message>
    <message>
        <source>{} is in {}</source>
        <translation>{} podano w {}</translation>
    </message>
    <message>
        <source>{} is larger than {} MB; that is no {}.</source>
        <translation>{} jest większy niż {} MB; to nie jest {}.</translation>
    </message>
    <message>
        <source>{} is no polar file: it must end in {}.</source>
        <translation>{} to nie plik biegunowej: nazwa musi kończyć się na {}.</translation>
    </message>
    <message>
        <source>{} is not a text file; choose a {} in text form (CSV).</source>
        <translation>{} nie jest plikiem tekstowym; wybierz plik ({}) w postaci tekstu (CSV).</translation>
    </message>
    <message>
        <source>{} is not the mask of 21600 x 43200 cells that SeaCruise can read.</source>
        <translation>{} nie jest maską o 21600 x 43200 komórkach, którą SeaCruise umie odczytać.</translation>
    </message>
    <message>
        <source>{} left today</source>
        <translation>na dziś zostało {}</translation>
    </message>
    <message>
        <source>{} lies in a zone that is closed to you ({}); take the zone out of the layers or choose another port.</source>
        <translation>{} leży w strefie, która jest dla ciebie zamknięta ({}); usuń strefę z warstw albo wybierz inny port.</translation>
    </message>
    <message>
        <source>{} log against receiver</source>
        <translation>{} log niezgodny z odbiornikiem</translation>
    </message>
    <message>
        <source>{} loses {} at {}; {}.</source>
        <translation>{} traci {} o {}; {}.</translation>
    </message>
    <message>
        <source>{} members</source>
        <translation>człony: {}</translation>
    </message>
    <message>
        <source>{} members of departure {} of {}</source>
        <translation>{} członów wyjścia {} z {}</translation>
    </message>
    <message>
        <source>{} missing wind or speed</source>
        <translation>{} bez wiatru lub prędkości</translation>
    </message>
    <message>
        <source>{} names no model of Storm Glass; write stormglass, stormglass:noaa, or stormglass:ecmwf+noaa for the mean of several.</source>
        <translation>{} nie nazywa żadnego modelu Storm Glass; napisz stormglass, stormglass:noaa albo stormglass:ecmwf+noaa dla średniej z kilku.</translation>
    </message>
    <message>
        <source>{} nm are a beat or run in water too narrow to plan the boards; they are reckoned at the speed made good.</source>
        <translation>Na {} Mm halsówki (pod wiatr lub z wiatrem) woda jest za wąska, by zaplanować halsy; liczono z prędkością zysku (VMG).</translation>
    </message>
    <message>
        <source>{} of the hours are from a coarser grid of {} degrees.</source>
        <translation>Godziny z rzadszej siatki: {}; jej oczko to {} stopni.</translation>
    </message>
    <message>
        <source>{} of {} hours are from {}, where {} {} none.</source>
        <translation>{} z {} h pochodzi z {}, gdzie {} {} nie ma.</translation>
    </message>
    <message>
        <source>{} of {} is out of range; give {} to {}.</source>
        <translation>{}: {} jest poza zakresem; podaj od {} do {}.</translation>
    </message>
    <message>
        <source>{} of {} is {}, not a time; write it like 2026-07-01T06:00Z.</source>
        <translation>{} w {} to {}, a nie czas; zapisz go tak: 2026-07-01T06:00Z.</translation>
    </message>
    <message>
        <source>{} of {} members are used, at the {} times they have in common.</source>
        <translation>Używanych jest {} z {} członów, w tylu wspólnych chwilach: {}.</translation>
    </message>
    <message>
        <source>{} of {} places have an answer; the rest is filled in.</source>
        <translation>Odpowiedź ma {} z {} miejsc; reszta jest uzupełniona.</translation>
    </message>
    <message>
        <source>{} of {} places have an answer; the wind between them is filled in.</source>
        <translation>Odpowiedź ma {} z {} miejsc; wiatr między nimi jest uzupełniony.</translation>
    </message>
    <message>
        <source>{} of {} requests left today, {}; a passage takes up to {}</source>
        <translation>na dziś zostało {} z {} zapytań, {}; trasa zużywa do {}</translation>
    </message>
    <message>
        <source>{} passages are too many at once (the most is {}); ask for fewer departures.</source>
        <translation>{} tras to za dużo naraz (najwyżej {}); zażądaj mniej wyjść.</translation>
    </message>
    <message>
        <source>{} passages{} are too many at once (the most is {}); ask for fewer departures.</source>
        <translation>{} tras{} to za dużo naraz (najwyżej {}); zażądaj mniej wyjść.</translation>
    </message>
    <message>
        <source>{} places</source>
        <translation>miejsca: {}</translation>
    </message>
    <message>
        <source>{} ports</source>
        <translation>{} portów</translation>
    </message>
    <message>
        <source>{} refuses the request (HTTP {}): {}.</source>
        <translation>{} odrzuca zapytanie (HTTP {}): {}.</translation>
    </message>
    <message>
        <source>{} refuses this program or this network (HTTP 403); choose another forecast.</source>
        <translation>{} odrzuca ten program lub tę sieć (HTTP 403); wybierz inną prognozę.</translation>
    </message>
    <message>
        <source>{} sent a refusal in place of a forecast ({}); try again later.</source>
        <translation>{}: odmowa zamiast prognozy ({}); spróbuj później.</translation>
    </message>
    <message>
        <source>{} sent a wind of {} m/s, which cannot be; try again later.</source>
        <translation>{}: przysłano wiatr {} m/s, co jest niemożliwe; spróbuj później.</translation>
    </message>
    <message>
        <source>{} sent an answer of another shape than expected ({} in {}).</source>
        <translation>{}: odpowiedź ma inną postać, niż oczekiwano ({} w {}).</translation>
    </message>
    <message>
        <source>{} sent an answer of another shape than expected ({}).</source>
        <translation>{}: odpowiedź ma inną postać, niż oczekiwano ({}).</translation>
    </message>
    <message>
        <source>{} sent an answer that is incomplete or not JSON; try again later.</source>
        <translation>{}: odpowiedź jest niepełna albo nie jest to JSON; spróbuj później.</translation>
    </message>
    <message>
        <source>{} sent less than {} hours of wind; try again later.</source>
        <translation>{}: przysłano mniej niż {} h wiatru; spróbuj później.</translation>
    </message>
    <message>
        <source>{} sent neither waves nor current for this area.</source>
        <translation>{}: nie przysłano ani fal, ani prądu dla tego obszaru.</translation>
    </message>
    <message>
        <source>{} sent no ensemble: members are missing; choose another forecast.</source>
        <translation>{}: nie przysłano wiązki, brakuje członów; wybierz inną prognozę.</translation>
    </message>
    <message>
        <source>{} sent no wind speed with a direction for any hour; try again later.</source>
        <translation>{}: dla żadnej godziny nie przysłano prędkości wiatru z kierunkiem; spróbuj później.</translation>
    </message>
    <message>
        <source>{} sent the request on to another address, which is not followed: a network may want you to sign in first, or the service&apos;s address in the environment is wrong.</source>
        <translation>{}: zapytanie przekierowano na inny adres, a tego program nie robi: sieć może wymagać zalogowania albo adres usługi w zmiennych środowiska jest błędny.</translation>
    </message>
    <message>
        <source>{} stopped</source>
        <translation>{} na postoju</translation>
    </message>
    <message>
        <source>{} to {} N, {} to {} E</source>
        <translation>{}–{}° N, {}–{}° E</translation>
    </message>
    <message>
        <source>{} to {} UTC</source>
        <translation>od {} do {} UTC</translation>
    </message>
    <message>
        <source>{} turning</source>
        <translation>{} przy zmianie kursu</translation>
    </message>
    <message>
        <source>{} under engine</source>
        <translation>{} na silniku</translation>
    </message>
    <message>
        <source>{} ways out were sailed again: their times are {} to {} % off those told.</source>
        <translation>Dróg tam sprawdzonych odcinek po odcinku: {}; ich czasy różnią się od podanych o {} do {} %.</translation>
    </message>
    <message>
        <source>{} wind shifting</source>
        <translation>{} przy zmiennym wietrze</translation>
    </message>
    <message>
        <source>{} winds are too many for the picture {}; give {} at most.</source>
        <translation>Tyle wiatrów ({}) to za dużo dla rysunku {}; podaj najwyżej {}.</translation>
    </message>
    <message>
        <source>{} yachts cannot be told apart; compare {} at most.</source>
        <translation>Tylu jachtów ({}) nie da się odróżnić; porównaj najwyżej {}.</translation>
    </message>
    <message>
        <source>{}, and she arrives at {} UTC at the earliest; choose a later arrival.</source>
        <translation>{}, a jacht przybywa najwcześniej {} UTC; wybierz późniejsze przybycie.</translation>
    </message>
    <message>
        <source>{}, cell {}</source>
        <translation>{}, komórka {}</translation>
    </message>
    <message>
        <source>{}, line 1: the header must be {}.</source>
        <translation>{}, wiersz 1: nagłówek musi brzmieć {}.</translation>
    </message>
    <message>
        <source>{}, line {}</source>
        <translation>{}, wiersz {}</translation>
    </message>
    <message>
        <source>{}, line {}: {}; check the quotation marks.</source>
        <translation>{}, wiersz {}: {}; sprawdź cudzysłowy.</translation>
    </message>
    <message>
        <source>{}, mean of {} members</source>
        <translation>{}, średnia z {} członów</translation>
    </message>
    <message>
        <source>{}, member {}</source>
        <translation>{}, człon {}</translation>
    </message>
    <message>
        <source>{}, row {}</source>
        <translation>{}, wiersz {}</translation>
    </message>
    <message>
        <source>{}, which is no forecast.</source>
        <translation>{}; to nie prognoza.</translation>
    </message>
    <message>
        <source>{}, wind speeds</source>
        <translation>{}, prędkości wiatru</translation>
    </message>
    <message>
        <source>{}, {} is no position</source>
        <translation>{}, {} to nie pozycja</translation>
    </message>
    <message>
        <source>{}, {}; correct it or choose another polar file.</source>
        <translation>{}, {}; popraw to albo wybierz inny plik biegunowej.</translation>
    </message>
    <message>
        <source>{}: a boat speed of {} kn is not within 0 and {}</source>
        <translation>{}: prędkość jachtu {} kn nie leży między 0 a {}</translation>
    </message>
    <message>
        <source>{}: a list of figures is missing</source>
        <translation>{}: brakuje listy liczb</translation>
    </message>
    <message>
        <source>{}: a wind angle of {} degrees is not within 0 and 180</source>
        <translation>{}: kąt wiatru {} stopni nie leży między 0 a 180</translation>
    </message>
    <message>
        <source>{}: a wind speed of {} kn is not within 0 and {}</source>
        <translation>{}: prędkość wiatru {} kn nie leży między 0 a {}</translation>
    </message>
    <message>
        <source>{}: lat {} is not within -90 and 90{}.</source>
        <translation>{}: szerokość {} nie leży między -90 a 90{}.</translation>
    </message>
    <message>
        <source>{}: lon {} is not within -180 and 180.</source>
        <translation>{}: długość {} nie leży między -180 a 180.</translation>
    </message>
    <message>
        <source>{}: no request needed, the answers kept are new enough</source>
        <translation>{}: zapytanie niepotrzebne, przechowane odpowiedzi są dość nowe</translation>
    </message>
    <message>
        <source>{}: the country {} is not a code of two letters such as PL.</source>
        <translation>{}: kraj {} nie jest dwuliterowym kodem takim jak PL.</translation>
    </message>
    <message>
        <source>{}: the name is missing.</source>
        <translation>{}: brakuje nazwy.</translation>
    </message>
    <message>
        <source>{}: the wind speed {} kn is there twice</source>
        <translation>{}: prędkość wiatru {} kn jest tu dwa razy</translation>
    </message>
    <message>
        <source>{}: the wind speeds must increase, {} kn comes after {}</source>
        <translation>{}: prędkości wiatru muszą rosnąć, a {} kn jest po {}</translation>
    </message>
    <message>
        <source>{}: the yacht {} is also in {}; rename one of them.</source>
        <translation>{}: jacht {} jest też w {}; zmień nazwę jednego z nich.</translation>
    </message>
    <message>
        <source>{}: they have no area in common and cannot be averaged; give one of them.</source>
        <translation>{}: nie mają wspólnego obszaru i nie można ich uśrednić; podaj jedną z nich.</translation>
    </message>
    <message>
        <source>{}: they have no time in common and cannot be averaged; give one of them.</source>
        <translation>{}: nie mają wspólnego czasu i nie można ich uśrednić; podaj jedną z nich.</translation>
    </message>
    <message>
        <source>{}: this is no object with named parts</source>
        <translation>{}: to nie jest obiekt z nazwanymi częściami</translation>
    </message>
    <message>
        <source>{}: you have the yacht {} in {}; rename one of them.</source>
        <translation>{}: jacht {} masz już w {}; zmień nazwę jednego z nich.</translation>
    </message>
    <message>
        <source>{}: {} at lat {}, lon {} is far from {}; lat and lon swapped?</source>
        <translation>{}: {} na szerokości {} i długości {} jest daleko od {}; zamieniono szerokość z długością?</translation>
    </message>
    <message>
        <source>{}: {} degrees at {} kn has two speeds, {} and {} kn</source>
        <translation>{}: {} stopni przy {} kn ma dwie prędkości, {} i {} kn</translation>
    </message>
    <message>
        <source>{}: {} degrees is no angle of a best VMG</source>
        <translation>{}: {} stopni to nie kąt najlepszego VMG</translation>
    </message>
    <message>
        <source>{}: {} figures for {} wind speeds</source>
        <translation>{}: liczb jest {}, a prędkości wiatru {}</translation>
    </message>
    <message>
        <source>{}: {} is already in line {}; give each port its own name.</source>
        <translation>{}: {} jest już w wierszu {}; każdemu portowi nadaj własną nazwę.</translation>
    </message>
    <message>
        <source>{}: {} is missing; write degrees such as {}.</source>
        <translation>{}: brakuje {}; podaj stopnie, np. {}.</translation>
    </message>
    <message>
        <source>{}: {} is not a number</source>
        <translation>{}: {} nie jest liczbą</translation>
    </message>
    <message>
        <source>{}: {} is not a number ({})</source>
        <translation>{}: {} nie jest liczbą ({})</translation>
    </message>
    <message>
        <source>{}: {} requests for {} places</source>
        <translation>{}: zapytań {} o miejsca w liczbie {}</translation>
    </message>
    <message>
        <source>{}: {} request{}</source>
        <translation>{0}: zapytań {1}</translation>
    </message>
    <message>
        <source>{}: {} rows for {} wind angles</source>
        <translation>{}: wierszy jest {}, a kątów wiatru {}</translation>
    </message>
    <message>
        <source>{}: {} values where {} are needed; put a name that has a comma into quotation marks.</source>
        <translation>{}: wartości jest {}, a potrzeba {}; nazwę z przecinkiem ujmij w cudzysłów.</translation>
    </message>
    <message>
        <source>{}: {} {} is in degrees and minutes; write decimal degrees such as {}.</source>
        <translation>{}: {} {} podano w stopniach i minutach; podaj stopnie dziesiętne, np. {}.</translation>
    </message>
    <message>
        <source>{}: {} {} is not a number; write decimal degrees such as {}.</source>
        <translation>{}: {} {} nie jest liczbą; podaj stopnie dziesiętne, np. {}.</translation>
    </message>
    <message>
        <source>{}; choose a later arrival.</source>
        <translation>{}; wybierz późniejsze przybycie.</translation>
    </message>
    <message>
        <source>{}; choose another place</source>
        <translation>{}; wybierz inne miejsce</translation>
    </message>
    <message>
        <source>{}; choose another place or make room there</source>
        <translation>{}; wybierz inne miejsce albo zwolnij tam miejsce</translation>
    </message>
    <message>
        <source>{}; how old that forecast is it does not say.</source>
        <translation>{}; nie podaje, jak stara jest ta prognoza.</translation>
    </message>
    <message>
        <source>{}; it wants a contact of those who ask: set SEACRUISE_CONTACT to your e-mail or site</source>
        <translation>{}; wymaga kontaktu do pytającego: ustaw SEACRUISE_CONTACT na swój e-mail lub stronę</translation>
    </message>
    <message>
        <source>{}; that forecast is {} old.</source>
        <translation>{}; wiek tej prognozy: {}.</translation>
    </message>
    <message>
        <source>{}{} request{}</source>
        <translation>zapytania: {0}{1}</translation>
    </message>
</context>
<context>
    <name>depth</name>
    <message>
        <source>tint about {low:.0f}–{high:.0f} m</source>
        <translation>głębokość ok. {low:.0f}–{high:.0f} m</translation>
    </message>
    <message>
        <source>tint over about {metres:.0f} m</source>
        <translation>głębokość ponad ok. {metres:.0f} m</translation>
    </message>
    <message>
        <source>tint under about {metres:.0f} m</source>
        <translation>głębokość poniżej ok. {metres:.0f} m</translation>
    </message>
    <message>
        <source>{tint} (coarse)</source>
        <translation>{tint} (z grubsza)</translation>
    </message>
    <message>
        <source>{tint} (coarse, not for navigation)</source>
        <translation>{tint} (z grubsza, nie do nawigacji)</translation>
    </message>
</context>
<context>
    <name>isochrones</name>
    <message>
        <source>{hours:g} h</source>
        <translation>{hours:g} h</translation>
    </message>
</context>
<context>
    <name>jobs</name>
    <message>
        <source>SeaCruise made a mistake of its own ({kind}); what you had is kept. The details are in seacruise.log: see Help, About.</source>
        <translation>Błąd wewnętrzny SeaCruise ({kind}); to, co było, zostało zachowane. Szczegóły są w pliku seacruise.log: zobacz Pomoc, O programie.</translation>
    </message>
</context>
<context>
    <name>language</name>
    <message>
        <source>As the system</source>
        <translation>Jak w systemie</translation>
    </message>
</context>
<context>
    <name>legend</name>
    <message>
        <source>Angle to the wind (TWA, °)</source>
        <translation>Kąt do wiatru (TWA, °)</translation>
    </message>
    <message>
        <source>Boat speed (kn)</source>
        <translation>Prędkość jachtu (kn)</translation>
    </message>
    <message>
        <source>Depth (m), coarse: not for navigation</source>
        <translation>Głębokość (m), z grubsza: nie do nawigacji</translation>
    </message>
    <message>
        <source>Fastest in each of {n} members</source>
        <translation>Najszybsza w każdym z {n} członów</translation>
    </message>
    <message>
        <source>Point of sail</source>
        <translation>Kurs względem wiatru</translation>
    </message>
    <message>
        <source>Wind on the chart ({unit})</source>
        <translation>Wiatr na mapie ({unit})</translation>
    </message>
    <message>
        <source>Wind on the route (TWS, {unit})</source>
        <translation>Wiatr na trasie (TWS, {unit})</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>półwiatr</translation>
    </message>
    <message>
        <source>broad</source>
        <translation>baksztag</translation>
    </message>
    <message>
        <source>close</source>
        <translation>bajdewind</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>silnik</translation>
    </message>
    <message>
        <source>fetch</source>
        <translation>pełny bajdewind</translation>
    </message>
    <message>
        <source>run</source>
        <translation>fordewind</translation>
    </message>
</context>
<context>
    <name>legs</name>
    <message>
        <source>Angle to the wind in a sailor&apos;s word</source>
        <translation>Kurs względem wiatru</translation>
    </message>
    <message>
        <source>Best sail where the leg begins</source>
        <translation>Najlepszy żagiel na początku odcinka</translation>
    </message>
    <message>
        <source>Boat kn</source>
        <translation>Jacht kn</translation>
    </message>
    <message>
        <source>COG</source>
        <translation>COG</translation>
    </message>
    <message>
        <source>Course over ground, degrees true</source>
        <translation>Kąt drogi nad dnem (KDd), stopnie rzeczywiste</translation>
    </message>
    <message>
        <source>Direction the true wind comes from</source>
        <translation>Kierunek, z którego wieje wiatr rzeczywisty</translation>
    </message>
    <message>
        <source>Leg {unit}</source>
        <translation>Odc. {unit}</translation>
    </message>
    <message>
        <source>Length of the leg</source>
        <translation>Długość odcinka</translation>
    </message>
    <message>
        <source>Point of sail</source>
        <translation>Do wiatru</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Pozycja</translation>
    </message>
    <message>
        <source>Sail</source>
        <translation>Żagiel</translation>
    </message>
    <message>
        <source>Side the wind comes from, or engine</source>
        <translation>Strona, z której wieje wiatr, albo silnik</translation>
    </message>
    <message>
        <source>Speed through the water, knots</source>
        <translation>Prędkość po wodzie, węzły</translation>
    </message>
    <message>
        <source>TWA</source>
        <translation>TWA</translation>
    </message>
    <message>
        <source>TWD</source>
        <translation>TWD</translation>
    </message>
    <message>
        <source>TWS {unit}</source>
        <translation>TWS {unit}</translation>
    </message>
    <message>
        <source>Tack</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>Time ({zone})</source>
        <translation>Czas ({zone})</translation>
    </message>
    <message>
        <source>True wind angle, 0° ahead to 180° astern</source>
        <translation>Kąt wiatru rzeczywistego, od 0° z dziobu do 180° z rufy</translation>
    </message>
    <message>
        <source>True wind speed where the leg begins</source>
        <translation>Prędkość wiatru rzeczywistego na początku odcinka</translation>
    </message>
    <message>
        <source>When the leg begins</source>
        <translation>Kiedy zaczyna się odcinek</translation>
    </message>
    <message>
        <source>Where the leg begins</source>
        <translation>Gdzie zaczyna się odcinek</translation>
    </message>
    <message>
        <source>arrival</source>
        <translation>przybycie</translation>
    </message>
    <message>
        <source>beam reach</source>
        <translation>półwiatr</translation>
    </message>
    <message>
        <source>both</source>
        <translation>oba</translation>
    </message>
    <message>
        <source>broad reach</source>
        <translation>baksztag</translation>
    </message>
    <message>
        <source>close reach</source>
        <translation>pełny bajdewind</translation>
    </message>
    <message>
        <source>close-hauled</source>
        <translation>bajdewind</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>silnik</translation>
    </message>
    <message>
        <source>port</source>
        <translation>lewy</translation>
    </message>
    <message>
        <source>run</source>
        <translation>fordewind</translation>
    </message>
    <message>
        <source>starboard</source>
        <translation>prawy</translation>
    </message>
</context>
<context>
    <name>log</name>
    <message>
        <source>Position</source>
        <translation>Pozycja</translation>
    </message>
    <message>
        <source>Time ({zone})</source>
        <translation>Czas ({zone})</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Zdarzenie</translation>
    </message>
</context>
<context>
    <name>members</name>
    <message>
        <source>Along it she does not arrive in {n} of {total}.</source>
        <translation>Płynąc nią, jacht nie dociera do celu w {n} z {total}.</translation>
    </message>
    <message>
        <source>In {n} members</source>
        <translation>Człony prognozy ({n})</translation>
    </message>
    <message>
        <source>In {n} of {total} members so far</source>
        <translation>Dotąd {n} z {total} członów</translation>
    </message>
    <message>
        <source>No passage in {n} of {total}.</source>
        <translation>Brak trasy w {n} z {total}.</translation>
    </message>
    <message>
        <source>Sailing the members of the forecast…</source>
        <translation>Obliczanie tras dla członów prognozy…</translation>
    </message>
    <message>
        <source>The planned line takes {hours}.</source>
        <translation>Zaplanowana trasa trwa {hours}.</translation>
    </message>
    <message>
        <source>about {middle}</source>
        <translation>około {middle}</translation>
    </message>
    <message>
        <source>hardly ever arrives</source>
        <translation>jacht prawie nigdy nie dopływa</translation>
    </message>
    <message>
        <source>{head}: {hours}.</source>
        <translation>{head}: {hours}.</translation>
    </message>
    <message>
        <source>{low} at best (10 %)</source>
        <translation>w najlepszym razie {low} (10 %)</translation>
    </message>
    <message>
        <source>{low} to {high} (10 to 90 %), median {middle}</source>
        <translation>od {low} do {high} (10–90 %), mediana {middle}</translation>
    </message>
    <message>
        <source>{n} h</source>
        <translation>{n} h</translation>
    </message>
    <message>
        <source>{n} of {total} go {side}, as planned.</source>
        <translation>{n} z {total}: {side}, zgodnie z planem.</translation>
    </message>
    <message>
        <source>{n} of {total} go {side}, unlike the plan.</source>
        <translation>{n} z {total}: {side}, inaczej niż w planie.</translation>
    </message>
    <message>
        <source>{n} of {total} members</source>
        <translation>{n} z {total} członów</translation>
    </message>
    <message>
        <source>{n} of {total} members sailed so far…</source>
        <translation>Obliczono dotąd {n} z {total} członów…</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>A newer one may change the passage; calculate again when you are online.</source>
        <translation>Nowsza może zmienić trasę; oblicz ponownie, gdy będziesz w sieci.</translation>
    </message>
    <message>
        <source>About SeaCruise…</source>
        <translation>O programie SeaCruise…</translation>
    </message>
    <message>
        <source>About this forecast</source>
        <translation>O tej prognozie</translation>
    </message>
    <message>
        <source>Allow tacking, or leave at another time.</source>
        <translation>Zezwól na halsowanie albo wyjdź o innej porze.</translation>
    </message>
    <message>
        <source>Change the limits…</source>
        <translation>Zmień ograniczenia…</translation>
    </message>
    <message>
        <source>Check it on the weather page (F3); until then there is practice weather.</source>
        <translation>Sprawdź go na stronie pogody (F3); do tego czasu jest pogoda ćwiczebna.</translation>
    </message>
    <message>
        <source>Check the network and try again; until then there is practice weather.</source>
        <translation>Sprawdź sieć i spróbuj ponownie; do tego czasu jest pogoda ćwiczebna.</translation>
    </message>
    <message>
        <source>Choose a neighbouring port, or a position in open water.</source>
        <translation>Wybierz sąsiedni port albo pozycję na otwartej wodzie.</translation>
    </message>
    <message>
        <source>Choose another folder or name; the passage is still here.</source>
        <translation>Wybierz inny folder lub inną nazwę; trasa nadal tu jest.</translation>
    </message>
    <message>
        <source>Choose ports and a departure that the forecast covers.</source>
        <translation>Wybierz porty i wyjście, które obejmuje prognoza.</translation>
    </message>
    <message>
        <source>Everything else is as it was.</source>
        <translation>Poza tym nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>Leave at another time, or let the engine help in light wind.</source>
        <translation>Wyjdź o innej porze albo pozwól silnikowi pomóc przy słabym wietrze.</translation>
    </message>
    <message>
        <source>Leave when it is open, or take it off the chart: right-click on it, or Ctrl+Z.</source>
        <translation>Wyjdź, gdy będzie otwarta, albo zdejmij ją z mapy: prawy przycisk na niej albo Ctrl+Z.</translation>
    </message>
    <message>
        <source>Motor below 3 kn</source>
        <translation>Silnik poniżej 3 kn</translation>
    </message>
    <message>
        <source>No connection to the weather service</source>
        <translation>Brak połączenia z usługą pogodową</translation>
    </message>
    <message>
        <source>No passage</source>
        <translation>Brak trasy</translation>
    </message>
    <message>
        <source>No passage: a closed area</source>
        <translation>Brak trasy: obszar zamknięty</translation>
    </message>
    <message>
        <source>No passage: becalmed</source>
        <translation>Brak trasy: cisza</translation>
    </message>
    <message>
        <source>No passage: dead against the wind</source>
        <translation>Brak trasy: wprost pod wiatr</translation>
    </message>
    <message>
        <source>No passage: no way by water</source>
        <translation>Brak trasy: nie ma drogi wodnej</translation>
    </message>
    <message>
        <source>No passage: outside the forecast</source>
        <translation>Brak trasy: poza prognozą</translation>
    </message>
    <message>
        <source>No passage: too much wind</source>
        <translation>Brak trasy: za silny wiatr</translation>
    </message>
    <message>
        <source>Not a forecast for today</source>
        <translation>To nie prognoza na dziś</translation>
    </message>
    <message>
        <source>Paste one on the weather page (F3); without a key there is Open-Meteo, or practice weather.</source>
        <translation>Wklej go na stronie pogody (F3); bez klucza jest Open-Meteo albo pogoda ćwiczebna.</translation>
    </message>
    <message>
        <source>Please check what was given</source>
        <translation>Sprawdź wpisane dane</translation>
    </message>
    <message>
        <source>Raise your limit of wind if the crew can stand it, or leave at another time.</source>
        <translation>Podnieś ograniczenie wiatru, jeśli załoga da radę, albo wyjdź o innej porze.</translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation>Pokaż to miejsce</translation>
    </message>
    <message>
        <source>Something that was saved is damaged</source>
        <translation>Zapisane dane są uszkodzone</translation>
    </message>
    <message>
        <source>Something went wrong inside SeaCruise</source>
        <translation>Błąd wewnętrzny SeaCruise</translation>
    </message>
    <message>
        <source>Start and end are the same</source>
        <translation>Start i cel są takie same</translation>
    </message>
    <message>
        <source>Storm Glass does not accept the key</source>
        <translation>Storm Glass nie przyjmuje klucza</translation>
    </message>
    <message>
        <source>Storm Glass needs a key</source>
        <translation>Storm Glass wymaga klucza</translation>
    </message>
    <message>
        <source>That did not work</source>
        <translation>To się nie udało</translation>
    </message>
    <message>
        <source>The count starts again at 00:00 UTC; until then use a file or practice weather.</source>
        <translation>Limit odnawia się o 00:00 UTC; do tego czasu użyj pliku albo pogody ćwiczebnej.</translation>
    </message>
    <message>
        <source>The file was not saved</source>
        <translation>Pliku nie zapisano</translation>
    </message>
    <message>
        <source>The forecast does not cover this departure</source>
        <translation>Prognoza nie obejmuje tego wyjścia</translation>
    </message>
    <message>
        <source>The forecast is {age} old</source>
        <translation>Prognoza jest sprzed {age}</translation>
    </message>
    <message>
        <source>The weather cannot be used</source>
        <translation>Pogody nie można użyć</translation>
    </message>
    <message>
        <source>The weather service does not answer</source>
        <translation>Usługa pogodowa nie odpowiada</translation>
    </message>
    <message>
        <source>The weather service is asked too often</source>
        <translation>Zbyt częste zapytania do usługi pogodowej</translation>
    </message>
    <message>
        <source>To the form</source>
        <translation>Do formularza</translation>
    </message>
    <message>
        <source>Today&apos;s requests are spent</source>
        <translation>Dzisiejszy limit zapytań jest wyczerpany</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Spróbuj ponownie</translation>
    </message>
    <message>
        <source>Try again in a few minutes; until then use a file or practice weather.</source>
        <translation>Spróbuj za kilka minut; do tego czasu użyj pliku albo pogody ćwiczebnej.</translation>
    </message>
    <message>
        <source>Try again in a moment; until then there is practice weather.</source>
        <translation>Spróbuj za chwilę; do tego czasu jest pogoda ćwiczebna.</translation>
    </message>
    <message>
        <source>Try again later, or choose another forecast.</source>
        <translation>Spróbuj później albo wybierz inną prognozę.</translation>
    </message>
    <message>
        <source>Type another destination, or use right-click on the chart.</source>
        <translation>Wpisz inny cel albo kliknij mapę prawym przyciskiem.</translation>
    </message>
    <message>
        <source>Use practice weather</source>
        <translation>Użyj pogody ćwiczebnej</translation>
    </message>
    <message>
        <source>Use the first hour covered</source>
        <translation>Użyj pierwszej objętej godziny</translation>
    </message>
    <message>
        <source>Weather…</source>
        <translation>Pogoda…</translation>
    </message>
    <message>
        <source>What you entered is still here. For a report: versions and seacruise.log, see About.</source>
        <translation>To, co wpisano, nadal tu jest. Do zgłoszenia: wersje i seacruise.log, zobacz O programie.</translation>
    </message>
    <message>
        <source>{n} days</source>
        <translation>{n} dni</translation>
    </message>
    <message>
        <source>{n} h</source>
        <translation>{n} h</translation>
    </message>
    <message>
        <source>{n} min</source>
        <translation>{n} min</translation>
    </message>
</context>
<context>
    <name>meteogram</name>
    <message>
        <source>, gusts {speed}</source>
        <translation>, porywy {speed}</translation>
    </message>
    <message>
        <source>Boat speed, kn</source>
        <translation>Prędkość jachtu, kn</translation>
    </message>
    <message>
        <source>TWA: port</source>
        <translation>TWA: lewy</translation>
    </message>
    <message>
        <source>Waves, {unit}</source>
        <translation>Fale, {unit}</translation>
    </message>
    <message>
        <source>Wind, {unit}</source>
        <translation>Wiatr, {unit}</translation>
    </message>
    <message>
        <source>after the end of the forecast</source>
        <translation>po końcu prognozy</translation>
    </message>
    <message>
        <source>after the forecast</source>
        <translation>po prognozie</translation>
    </message>
    <message>
        <source>current {speed:.1f} kn setting {direction}</source>
        <translation>prąd {speed:.1f} kn w kierunku {direction}</translation>
    </message>
    <message>
        <source>current, kn</source>
        <translation>prąd, kn</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>silnik</translation>
    </message>
    <message>
        <source>gusts</source>
        <translation>porywy</translation>
    </message>
    <message>
        <source>port</source>
        <translation>lewy</translation>
    </message>
    <message>
        <source>starboard</source>
        <translation>prawy</translation>
    </message>
    <message>
        <source>waves {height}</source>
        <translation>fale {height}</translation>
    </message>
    <message>
        <source>wind {speed} from {direction}</source>
        <translation>wiatr {speed} z {direction}</translation>
    </message>
    <message>
        <source>{speed:.1f} kn, TWA {angle:.0f}° {side}</source>
        <translation>{speed:.1f} kn, TWA {angle:.0f}° {side}</translation>
    </message>
</context>
<context>
    <name>narrative</name>
    <message numerus="yes">
        <source>%n gybe(s)</source>
        <translation>
            <numerusform>%n zwrot przez rufę</numerusform>
            <numerusform>%n zwroty przez rufę</numerusform>
            <numerusform>%n zwrotów przez rufę</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tack(s)</source>
        <translation>
            <numerusform>%n zwrot przez sztag</numerusform>
            <numerusform>%n zwroty przez sztag</numerusform>
            <numerusform>%n zwrotów przez sztag</numerusform>
        </translation>
    </message>
    <message>
        <source>Arrives in {place} after {hours} and {distance}.</source>
        <translation>Przybycie: {place}, po {hours} i {distance}.</translation>
    </message>
    <message>
        <source>Bears away to {course}; {how}.</source>
        <translation>Odpadnięcie na kurs {course}; {how}.</translation>
    </message>
    <message>
        <source>Begins to beat; {turns} until {time}, {wind}.</source>
        <translation>Początek halsówki; {turns} do {time}, {wind}.</translation>
    </message>
    <message>
        <source>Begins to run before the wind; {turns} until {time}, {wind}.</source>
        <translation>Początek żeglugi z wiatrem; {turns} do {time}, {wind}.</translation>
    </message>
    <message>
        <source>Gybes to {course}; {how}.</source>
        <translation>Zwrot przez rufę na kurs {course}; {how}.</translation>
    </message>
    <message>
        <source>Heads up to {course}; {how}.</source>
        <translation>Wyostrzenie na kurs {course}; {how}.</translation>
    </message>
    <message>
        <source>Highest waves of the passage, {height}.</source>
        <translation>Najwyższa fala na trasie, {height}.</translation>
    </message>
    <message>
        <source>Leaves {place} under engine; {how}.</source>
        <translation>Wyjście na silniku: {place}; {how}.</translation>
    </message>
    <message>
        <source>Leaves {place}; {how}.</source>
        <translation>Wyjście: {place}; {how}.</translation>
    </message>
    <message>
        <source>Off {place}, {distance} to port; {how}.</source>
        <translation>{place} na trawersie, {distance} z lewej burty; {how}.</translation>
    </message>
    <message>
        <source>Off {place}, {distance} to starboard; {how}.</source>
        <translation>{place} na trawersie, {distance} z prawej burty; {how}.</translation>
    </message>
    <message>
        <source>Passes close to {place}; {how}.</source>
        <translation>{place} w pobliżu; {how}.</translation>
    </message>
    <message>
        <source>Rounds {place}, {distance} to port; {how}.</source>
        <translation>Obejście: {place}, {distance} z lewej burty; {how}.</translation>
    </message>
    <message>
        <source>Rounds {place}, {distance} to starboard; {how}.</source>
        <translation>Obejście: {place}, {distance} z prawej burty; {how}.</translation>
    </message>
    <message>
        <source>Starts the engine; {how}.</source>
        <translation>Uruchomienie silnika; {how}.</translation>
    </message>
    <message>
        <source>Stops the engine; {how}.</source>
        <translation>Zatrzymanie silnika; {how}.</translation>
    </message>
    <message>
        <source>Strongest current of the passage, {speed} setting {course}.</source>
        <translation>Najsilniejszy prąd na trasie, {speed} w kierunku {course}.</translation>
    </message>
    <message>
        <source>Strongest wind of the passage, with gusts of {gusts}; {how}.</source>
        <translation>Najsilniejszy wiatr na trasie, w porywach {gusts}; {how}.</translation>
    </message>
    <message>
        <source>Strongest wind of the passage; {how}.</source>
        <translation>Najsilniejszy wiatr na trasie; {how}.</translation>
    </message>
    <message>
        <source>Sunrise; {how}.</source>
        <translation>Wschód słońca; {how}.</translation>
    </message>
    <message>
        <source>Sunset; {how}.</source>
        <translation>Zachód słońca; {how}.</translation>
    </message>
    <message>
        <source>Tacks to {course}; {how}.</source>
        <translation>Zwrot przez sztag na kurs {course}; {how}.</translation>
    </message>
    <message>
        <source>The forecast ends; from here on its last wind fades to the usual.</source>
        <translation>Koniec prognozy; odtąd jej ostatni wiatr przechodzi stopniowo w średni.</translation>
    </message>
    <message>
        <source>The forecast ends; from here on its last wind is held.</source>
        <translation>Koniec prognozy; odtąd utrzymany jest jej ostatni wiatr.</translation>
    </message>
    <message>
        <source>The wind backs; {how}.</source>
        <translation>Wiatr skręca w lewo; {how}.</translation>
    </message>
    <message>
        <source>The wind drops to force {force}; {how}.</source>
        <translation>Wiatr słabnie do {force} B; {how}.</translation>
    </message>
    <message>
        <source>The wind rises to force {force}; {how}.</source>
        <translation>Wiatr wzmaga się do {force} B; {how}.</translation>
    </message>
    <message>
        <source>The wind veers; {how}.</source>
        <translation>Wiatr skręca w prawo; {how}.</translation>
    </message>
    <message>
        <source>Waits {hours} in {place}, until what is not allowed has passed.</source>
        <translation>Postój {hours} w porcie {place}, aż miną warunki, których nie dopuszczasz.</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>cisza</translation>
    </message>
    <message>
        <source>{wind} forward of the port beam</source>
        <translation>{wind} z lewej burty, przed trawersem</translation>
    </message>
    <message>
        <source>{wind} forward of the starboard beam</source>
        <translation>{wind} z prawej burty, przed trawersem</translation>
    </message>
    <message>
        <source>{wind} from ahead</source>
        <translation>{wind} z dziobu</translation>
    </message>
    <message>
        <source>{wind} from dead astern</source>
        <translation>{wind} prosto z rufy</translation>
    </message>
    <message>
        <source>{wind} on the port beam</source>
        <translation>{wind} z trawersu lewej burty</translation>
    </message>
    <message>
        <source>{wind} on the port bow</source>
        <translation>{wind} z lewej strony dziobu</translation>
    </message>
    <message>
        <source>{wind} on the port quarter</source>
        <translation>{wind} z lewego baksztagu</translation>
    </message>
    <message>
        <source>{wind} on the starboard beam</source>
        <translation>{wind} z trawersu prawej burty</translation>
    </message>
    <message>
        <source>{wind} on the starboard bow</source>
        <translation>{wind} z prawej strony dziobu</translation>
    </message>
    <message>
        <source>{wind} on the starboard quarter</source>
        <translation>{wind} z prawego baksztagu</translation>
    </message>
    <message>
        <source>{wind}, beating in narrow water</source>
        <translation>{wind}, halsówka na wąskiej wodzie</translation>
    </message>
    <message>
        <source>{wind}, close-hauled on port tack</source>
        <translation>{wind}, bajdewind lewego halsu</translation>
    </message>
    <message>
        <source>{wind}, close-hauled on starboard tack</source>
        <translation>{wind}, bajdewind prawego halsu</translation>
    </message>
    <message>
        <source>{wind}, running in narrow water</source>
        <translation>{wind}, z wiatrem na wąskiej wodzie</translation>
    </message>
</context>
<context>
    <name>options</name>
    <message>
        <source>area</source>
        <translation>obszar</translation>
    </message>
    <message>
        <source>at most {n} tacks and gybes</source>
        <translation>zwrotów najwyżej {n}</translation>
    </message>
    <message>
        <source>at most {wind} of wind</source>
        <translation>wiatr najwyżej {wind}</translation>
    </message>
    <message>
        <source>boards of {n:g} h</source>
        <translation>halsy po {n:g} h</translation>
    </message>
    <message>
        <source>classic search</source>
        <translation>szukanie klasyczne</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>kierunki</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>elipsa</translation>
    </message>
    <message>
        <source>ends with the forecast</source>
        <translation>kończy się z prognozą</translation>
    </message>
    <message>
        <source>engine below {n:g} kn</source>
        <translation>silnik poniżej {n:g} kn</translation>
    </message>
    <message>
        <source>gusts to {wind}</source>
        <translation>porywy do {wind}</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>siatka</translation>
    </message>
    <message>
        <source>may wait {n:g} h</source>
        <translation>może czekać {n:g} h</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>no tacking</source>
        <translation>bez halsowania</translation>
    </message>
    <message>
        <source>penalty for turning [min for 10°]</source>
        <translation>kara za zmianę kursu [min na 10°]</translation>
    </message>
    <message>
        <source>rectangle</source>
        <translation>prostokąt</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>prostokątna</translation>
    </message>
    <message>
        <source>refinement</source>
        <translation>wygładzanie</translation>
    </message>
    <message>
        <source>safety radius [nm]</source>
        <translation>promień bezpieczeństwa [Mm]</translation>
    </message>
    <message>
        <source>spacing [nm]</source>
        <translation>odstęp [Mm]</translation>
    </message>
    <message>
        <source>waves to {height}</source>
        <translation>fale do {height}</translation>
    </message>
    <message>
        <source>wind fades after the forecast</source>
        <translation>po prognozie wiatr wygasa</translation>
    </message>
    <message>
        <source>without currents</source>
        <translation>bez prądów</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>tak</translation>
    </message>
    <message>
        <source>{distance} off the shore</source>
        <translation>{distance} od brzegu</translation>
    </message>
    <message>
        <source>{n:g} % at night</source>
        <translation>{n:g} % w nocy</translation>
    </message>
    <message>
        <source>{n:g} % less for each metre of waves</source>
        <translation>{n:g} % mniej na każdy metr fali</translation>
    </message>
    <message>
        <source>{n:g} % of the polar</source>
        <translation>{n:g} % biegunowej</translation>
    </message>
    <message>
        <source>{n:g} kn under engine</source>
        <translation>{n:g} kn na silniku</translation>
    </message>
    <message>
        <source>{n:g} l/h</source>
        <translation>{n:g} l/h</translation>
    </message>
    <message>
        <source>{n:g} min a gybe</source>
        <translation>{n:g} min na zwrot przez rufę</translation>
    </message>
    <message>
        <source>{n:g} min a tack</source>
        <translation>{n:g} min na zwrot przez sztag</translation>
    </message>
    <message>
        <source>{name} {value}</source>
        <translation>{name} {value}</translation>
    </message>
</context>
<context>
    <name>pages</name>
    <message>
        <source>Arrival</source>
        <translation>Przybycie</translation>
    </message>
    <message>
        <source>Arrives</source>
        <translation>Przybycie</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Powrót</translation>
    </message>
    <message>
        <source>Best is leaving {leaves}: {hours} under way.</source>
        <translation>Najlepsze wyjście: {leaves}, {hours} w drodze.</translation>
    </message>
    <message>
        <source>But the strongest wind is {wind}, not {other}.</source>
        <translation>Ale najsilniejszy wiatr to {wind} zamiast {other}.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Anulowano</translation>
    </message>
    <message>
        <source>Comp&amp;are</source>
        <translation>Po&amp;równaj</translation>
    </message>
    <message>
        <source>Departure</source>
        <translation>Wyjście</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Czas trwania</translation>
    </message>
    <message>
        <source>Fastest is {yacht}, leaving {leaves}: {hours} under way.</source>
        <translation>Najszybciej płynie {yacht}, wyjście: {leaves}, {hours} w drodze.</translation>
    </message>
    <message>
        <source>Fi&amp;nd ports</source>
        <translation>Znajdź po&amp;rty</translation>
    </message>
    <message>
        <source>Finds every port that you reach from the start of the form in the time you have, and whether you are back in time. Say how much time there is, and press Find ports.</source>
        <translation>Znajduje każdy port, do którego zdążysz dopłynąć od startu z formularza w dostępnym czasie, i mówi, czy zdążysz wrócić. Podaj, ile masz czasu, i naciśnij Znajdź porty.</translation>
    </message>
    <message>
        <source>Hours</source>
        <translation>Godziny</translation>
    </message>
    <message>
        <source>Hours in the dark</source>
        <translation>Godziny w nocy</translation>
    </message>
    <message>
        <source>Hours under engine</source>
        <translation>Godziny na silniku</translation>
    </message>
    <message>
        <source>It makes no difference when you leave: {hours} under way.</source>
        <translation>Nie ma znaczenia, kiedy wyjdziesz: {hours} w drodze.</translation>
    </message>
    <message>
        <source>Its water lies {distance} away.</source>
        <translation>Najbliższa dostępna woda leży {distance} od portu.</translation>
    </message>
    <message>
        <source>Latest departure from there that is back in time</source>
        <translation>Ostatnie wyjście stamtąd, które wraca na czas</translation>
    </message>
    <message>
        <source>Leave by</source>
        <translation>Najpóźniej</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Wyjście</translation>
    </message>
    <message>
        <source>Leaving as planned, {leaves}, is best: {hours} under way, up to {saves} less than later.</source>
        <translation>Najlepsze jest wyjście zgodne z planem ({leaves}): {hours} w drodze, do {saves} krócej niż później.</translation>
    </message>
    <message>
        <source>Leaving {leaves} is best: {hours} under way. Others seem shorter, but more than a tenth of them is beyond the forecast.</source>
        <translation>Najlepsze wyjście: {leaves}, {hours} w drodze. Inne wydają się krótsze, ale ponad jedna dziesiąta ich czasu leży poza prognozą.</translation>
    </message>
    <message>
        <source>Leaving {leaves} saves {saves}: {hours} under way instead of {other}.</source>
        <translation>Wyjście: {leaves} – krócej o {saves}, {hours} w drodze zamiast {other}.</translation>
    </message>
    <message>
        <source>Length of the way out</source>
        <translation>Długość drogi tam</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Silnik</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>Noc</translation>
    </message>
    <message>
        <source>No passage yet.</source>
        <translation>Nie ma jeszcze trasy.</translation>
    </message>
    <message>
        <source>No port is reached in {time}.</source>
        <translation>W czasie {time} nie da się dopłynąć do żadnego portu.</translation>
    </message>
    <message>
        <source>None of these departures leads to a passage; each row says why.</source>
        <translation>Żadne z tych wyjść nie daje trasy; każdy wiersz mówi dlaczego.</translation>
    </message>
    <message>
        <source>Nothing can be said yet about when to leave: more than a tenth of every passage is beyond the forecast. In the wind held from then on, leaving {leaves} is shortest: {hours} under way.</source>
        <translation>O terminie wyjścia nie można jeszcze nic powiedzieć: ponad jedna dziesiąta każdej trasy leży poza prognozą. Na wietrze utrzymanym od końca prognozy najkrócej trwa wyjście: {leaves}, {hours} w drodze.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>One port fits, {port}: {spare} to spare by {until}.</source>
        <translation>Mieści się jeden port: {port}, zapas {spare} do {until}.</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Tam</translation>
    </message>
    <message>
        <source>Part of the time closer than 60° to the true wind</source>
        <translation>Część czasu bliżej niż 60° od wiatru rzeczywistego</translation>
    </message>
    <message>
        <source>Plans the passage of the form for several departures, from its own on, and shows how long each takes, when it arrives and in what wind. Choose how many, and press Compare.</source>
        <translation>Planuje trasę z formularza dla kilku wyjść, począwszy od podanego, i pokazuje, ile trwa każda, kiedy jacht dopływa i przy jakim wietrze. Wybierz, ile ich ma być, i naciśnij Porównaj.</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Port and its country</source>
        <translation>Port i jego kraj</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Postęp</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Rozpoczynanie…</translation>
    </message>
    <message>
        <source>Strongest true wind</source>
        <translation>Najsilniejszy wiatr rzeczywisty</translation>
    </message>
    <message>
        <source>Time back, leaving after the stay</source>
        <translation>Czas powrotu, przy wyjściu po postoju</translation>
    </message>
    <message>
        <source>Time out</source>
        <translation>Czas drogi tam</translation>
    </message>
    <message>
        <source>Time to spare, or how much is missing</source>
        <translation>Zapas czasu albo ile go brakuje</translation>
    </message>
    <message>
        <source>Upwind</source>
        <translation>Na wiatr</translation>
    </message>
    <message>
        <source>What fits</source>
        <translation>Czy się mieści</translation>
    </message>
    <message>
        <source>What was found so far stays.</source>
        <translation>To, co dotąd znaleziono, zostaje.</translation>
    </message>
    <message>
        <source>When to go</source>
        <translation>Kiedy wyjść</translation>
    </message>
    <message>
        <source>Where to go</source>
        <translation>Dokąd płynąć</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wiatr</translation>
    </message>
    <message>
        <source>Yacht</source>
        <translation>Jacht</translation>
    </message>
    <message>
        <source>Yachts compared, by departure</source>
        <translation>Porównane jachty, według wyjścia</translation>
    </message>
    <message>
        <source>fits, {spare} to spare</source>
        <translation>mieści się, zapas {spare}</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nigdy</translation>
    </message>
    <message>
        <source>no time to sail back</source>
        <translation>nie ma czasu na powrót</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nieporównane</translation>
    </message>
    <message>
        <source>of {n} members 10 - 50 - 90 % need {band}</source>
        <translation>z {n} członów 10 - 50 - 90 % potrzebuje {band}</translation>
    </message>
    <message>
        <source>{h:.0f} h</source>
        <translation>{h:.0f} h</translation>
    </message>
    <message>
        <source>{h:.0f} h of the way are beyond the forecast.</source>
        <translation>{h:.0f} h drogi leży poza prognozą.</translation>
    </message>
    <message>
        <source>{hours} of it beyond the forecast</source>
        <translation>z tego {hours} poza prognozą</translation>
    </message>
    <message>
        <source>{h} h</source>
        <translation>{h} h</translation>
    </message>
    <message>
        <source>{h} h {m:02d}</source>
        <translation>{h} h {m:02d}</translation>
    </message>
    <message>
        <source>{h} h {m} min</source>
        <translation>{h} h {m} min</translation>
    </message>
    <message>
        <source>{leaves} is the only departure with a passage: {hours} under way.</source>
        <translation>{leaves} to jedyne wyjście z trasą: {hours} w drodze.</translation>
    </message>
    <message>
        <source>{leaves} to {arrives}: {hours}, {distance}</source>
        <translation>od {leaves} do {arrives}: {hours}, {distance}</translation>
    </message>
    <message>
        <source>{m} min</source>
        <translation>{m} min</translation>
    </message>
    <message>
        <source>{n} ports are reached by {until}; the farthest is {port}, with {spare} to spare.</source>
        <translation>Do {until} dopłyniesz do {n} portów; najdalszy to {port}, zapas {spare}.</translation>
    </message>
    <message>
        <source>{n} ports are reached, but none of them and back by {until}.</source>
        <translation>Dopłyniesz do {n} portów, ale z żadnego nie wrócisz do {until}.</translation>
    </message>
    <message>
        <source>{n} ports fit, back by {until}; the farthest is {port}, with {spare} to spare.</source>
        <translation>Do {until} wrócisz z {n} portów; najdalszy to {port}, zapas {spare}.</translation>
    </message>
    <message>
        <source>{over} too long</source>
        <translation>{over} za długo</translation>
    </message>
    <message>
        <source>{time} from {start}, leaving {leaves}, {yacht}</source>
        <translation>{start}: {time}, wyjście {leaves}, {yacht}</translation>
    </message>
    <message>
        <source>{yacht} is fastest.</source>
        <translation>Najszybciej płynie {yacht}.</translation>
    </message>
</context>
<context>
    <name>paper</name>
    <message>
        <source>, issued {when} UTC</source>
        <translation>, z {when} UTC</translation>
    </message>
    <message>
        <source>, {distance:.1f} nm from the harbour</source>
        <translation>, {distance:.1f} Mm od portu</translation>
    </message>
    <message>
        <source>Apr</source>
        <translation>kwi</translation>
    </message>
    <message>
        <source>Arrival</source>
        <translation>Przybycie</translation>
    </message>
    <message>
        <source>At night</source>
        <translation>W nocy</translation>
    </message>
    <message>
        <source>Aug</source>
        <translation>sie</translation>
    </message>
    <message>
        <source>BEYOND A LIMIT</source>
        <translation>POZA OGRANICZENIEM</translation>
    </message>
    <message>
        <source>Barbs: {when} UTC</source>
        <translation>Chorągiewki: {when} UTC</translation>
    </message>
    <message>
        <source>Boat speed [kn]</source>
        <translation>Prędkość jachtu [kn]</translation>
    </message>
    <message>
        <source>CROSSES A ZONE</source>
        <translation>PRZECINA STREFĘ</translation>
    </message>
    <message>
        <source>CROSSES LAND</source>
        <translation>PRZECINA LĄD</translation>
    </message>
    <message>
        <source>Coast: (c) OpenStreetMap contributors, ODbL; beyond the Baltic to 2 km. Polar: {yacht}.</source>
        <translation>Wybrzeże: (c) autorzy OpenStreetMap, ODbL; poza Bałtykiem do 2 km. Biegunowa: {yacht}.</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Kurs</translation>
    </message>
    <message>
        <source>Dec</source>
        <translation>gru</translation>
    </message>
    <message>
        <source>Departure</source>
        <translation>Wyjście</translation>
    </message>
    <message>
        <source>Dist nm</source>
        <translation>Odl. Mm</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Droga</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Silnik</translation>
    </message>
    <message>
        <source>Fading wind</source>
        <translation>Wiatr wygasający</translation>
    </message>
    <message>
        <source>Feb</source>
        <translation>lut</translation>
    </message>
    <message>
        <source>Fri</source>
        <translation>pt.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Skąd</translation>
    </message>
    <message>
        <source>Held wind</source>
        <translation>Wiatr utrzymany</translation>
    </message>
    <message>
        <source>Jan</source>
        <translation>sty</translation>
    </message>
    <message>
        <source>Jul</source>
        <translation>lip</translation>
    </message>
    <message>
        <source>Jun</source>
        <translation>cze</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Odcinki</translation>
    </message>
    <message>
        <source>Legs (continued)</source>
        <translation>Odcinki (cd.)</translation>
    </message>
    <message>
        <source>Log (UTC)</source>
        <translation>Dziennik (UTC)</translation>
    </message>
    <message>
        <source>Log (UTC, continued)</source>
        <translation>Dziennik (UTC, cd.)</translation>
    </message>
    <message>
        <source>Lower bound</source>
        <translation>Nie krócej niż</translation>
    </message>
    <message>
        <source>Manoeuvres</source>
        <translation>Zwroty</translation>
    </message>
    <message>
        <source>Mar</source>
        <translation>mar</translation>
    </message>
    <message>
        <source>May</source>
        <translation>maj</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Średnia prędkość</translation>
    </message>
    <message>
        <source>Mon</source>
        <translation>pon.</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nr</translation>
    </message>
    <message>
        <source>Not a navigation chart. A planning aid: check every leg on official charts before sailing.</source>
        <translation>To nie jest mapa nawigacyjna, lecz pomoc w planowaniu: przed wyjściem sprawdź każdy odcinek na mapach urzędowych.</translation>
    </message>
    <message>
        <source>Notices (continued)</source>
        <translation>Uwagi (cd.)</translation>
    </message>
    <message>
        <source>Nov</source>
        <translation>lis</translation>
    </message>
    <message>
        <source>Oct</source>
        <translation>paź</translation>
    </message>
    <message>
        <source>Page {number} of {count}</source>
        <translation>Strona {number} z {count}</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Pozycja</translation>
    </message>
    <message>
        <source>Sailed again</source>
        <translation>Sprawdzenie</translation>
    </message>
    <message>
        <source>Sat</source>
        <translation>sob.</translation>
    </message>
    <message>
        <source>Sep</source>
        <translation>wrz</translation>
    </message>
    <message>
        <source>Shaded: sun more than 6° below the horizon. Hatched: beyond the end of the forecast. Dotted: angle of the true wind.</source>
        <translation>Szare: słońce ponad 6° pod horyzontem. Kreskowane: po końcu prognozy. Kropkowane: kąt wiatru rzeczywistego.</translation>
    </message>
    <message>
        <source>Speed kn</source>
        <translation>Pręd. kn</translation>
    </message>
    <message>
        <source>Steer</source>
        <translation>Steruj</translation>
    </message>
    <message>
        <source>Strongest wind</source>
        <translation>Wiatr do</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>niedz.</translation>
    </message>
    <message>
        <source>TWA</source>
        <translation>TWA</translation>
    </message>
    <message>
        <source>TWD</source>
        <translation>TWD</translation>
    </message>
    <message>
        <source>TWS kn</source>
        <translation>TWS kn</translation>
    </message>
    <message>
        <source>Tack</source>
        <translation>Hals</translation>
    </message>
    <message>
        <source>The wind is of {when} UTC, {hours:.0f} h before departure.</source>
        <translation>Wiatr jest z {when} UTC, {hours:.0f} h przed wyjściem.</translation>
    </message>
    <message>
        <source>The wind is of {when} UTC.</source>
        <translation>Wiatr jest z {when} UTC.</translation>
    </message>
    <message>
        <source>Thu</source>
        <translation>czw.</translation>
    </message>
    <message>
        <source>Time (UTC)</source>
        <translation>Czas (UTC)</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Dokąd</translation>
    </message>
    <message>
        <source>True wind [kn]</source>
        <translation>Wiatr rzeczywisty [kn]</translation>
    </message>
    <message>
        <source>Tue</source>
        <translation>wt.</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Na zwroty</translation>
    </message>
    <message>
        <source>Waves [m]</source>
        <translation>Fale [m]</translation>
    </message>
    <message>
        <source>Weather along the passage</source>
        <translation>Pogoda na trasie</translation>
    </message>
    <message>
        <source>Wed</source>
        <translation>śr.</translation>
    </message>
    <message>
        <source>When this wind was issued is not known.</source>
        <translation>Nie wiadomo, kiedy wydano tę prognozę wiatru.</translation>
    </message>
    <message>
        <source>Wind angle [°]</source>
        <translation>Kąt wiatru [°]</translation>
    </message>
    <message>
        <source>Wind: {source}</source>
        <translation>Wiatr: {source}</translation>
    </message>
    <message>
        <source>Yacht</source>
        <translation>Jacht</translation>
    </message>
    <message>
        <source>and {n} smaller changes of course and wind</source>
        <translation>oraz {n} mniejszych zmian kursu i wiatru</translation>
    </message>
    <message>
        <source>beyond the forecast</source>
        <translation>poza prognozą</translation>
    </message>
    <message>
        <source>both</source>
        <translation>oba</translation>
    </message>
    <message>
        <source>clear of land</source>
        <translation>nie przecina lądu</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>silnik</translation>
    </message>
    <message>
        <source>gusts</source>
        <translation>porywy</translation>
    </message>
    <message>
        <source>nm</source>
        <translation>Mm</translation>
    </message>
    <message>
        <source>port</source>
        <translation>lewy</translation>
    </message>
    <message>
        <source>starboard</source>
        <translation>prawy</translation>
    </message>
    <message>
        <source>tacks {tacks}, gybes {gybes}, course changes {changes}</source>
        <translation>przez sztag {tacks}, przez rufę {gybes}, zmiany kursu {changes}</translation>
    </message>
    <message>
        <source>under engine</source>
        <translation>na silniku</translation>
    </message>
    <message>
        <source>within limits</source>
        <translation>w ramach ograniczeń</translation>
    </message>
    <message>
        <source>{begin} to {end} UTC</source>
        <translation>od {begin} do {end} UTC</translation>
    </message>
    <message>
        <source>{hours} beyond the forecast</source>
        <translation>{hours} poza prognozą</translation>
    </message>
    <message>
        <source>{hours} for manoeuvres</source>
        <translation>{hours}</translation>
    </message>
    <message>
        <source>{hours}, {litres:.0f} l of fuel</source>
        <translation>{hours}, {litres:.0f} l paliwa</translation>
    </message>
    <message>
        <source>{sailed:.1f} nm, {direct:.1f} nm direct</source>
        <translation>{sailed:.1f} Mm, w linii prostej {direct:.1f} Mm</translation>
    </message>
    <message>
        <source>{speed:.0f} kn</source>
        <translation>{speed:.0f} kn</translation>
    </message>
    <message>
        <source>{speed:.1f} kn</source>
        <translation>{speed:.1f} kn</translation>
    </message>
</context>
<context>
    <name>passages</name>
    <message>
        <source>Departure</source>
        <translation>Wyjście</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Czas trwania</translation>
    </message>
    <message>
        <source>How long the passage takes</source>
        <translation>Jak długo trwa trasa</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Name of the passage</source>
        <translation>Nazwa trasy</translation>
    </message>
    <message>
        <source>The yacht</source>
        <translation>Jacht</translation>
    </message>
    <message>
        <source>When she leaves</source>
        <translation>Kiedy jacht wychodzi</translation>
    </message>
    <message>
        <source>Yacht</source>
        <translation>Jacht</translation>
    </message>
</context>
<context>
    <name>readout</name>
    <message>
        <source>wind {twd} {tws}</source>
        <translation>wiatr {twd} {tws}</translation>
    </message>
    <message>
        <source>{bearing} from {name}</source>
        <translation>{bearing} od {name}</translation>
    </message>
</context>
<context>
    <name>route</name>
    <message>
        <source>sunrise {time}</source>
        <translation>wschód słońca {time}</translation>
    </message>
    <message>
        <source>sunset {time}</source>
        <translation>zachód słońca {time}</translation>
    </message>
</context>
<context>
    <name>system</name>
    <message>
        <source>File name too long</source>
        <translation>Nazwa pliku jest za długa</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Brak miejsca na dysku</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Nie ma takiego pliku ani folderu</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>To nie jest folder</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Brak uprawnień</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dysk jest tylko do odczytu</translation>
    </message>
</context>
<context>
    <name>undo</name>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ponów</translation>
    </message>
    <message>
        <source>&amp;Redo: {what}</source>
        <translation>&amp;Ponów: {what}</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Cofnij</translation>
    </message>
    <message>
        <source>&amp;Undo: {what}</source>
        <translation>&amp;Cofnij: {what}</translation>
    </message>
    <message>
        <source>departure {moment}</source>
        <translation>wyjście {moment}</translation>
    </message>
    <message>
        <source>destination {port}</source>
        <translation>cel {port}</translation>
    </message>
    <message>
        <source>forecast</source>
        <translation>prognoza</translation>
    </message>
    <message>
        <source>how she is sailed</source>
        <translation>sposób żeglugi</translation>
    </message>
    <message>
        <source>passage</source>
        <translation>trasa</translation>
    </message>
    <message>
        <source>sailing by way of a place</source>
        <translation>trasa przez wskazane miejsce</translation>
    </message>
    <message>
        <source>sailing direct</source>
        <translation>trasa bezpośrednia</translation>
    </message>
    <message>
        <source>start and end</source>
        <translation>start i cel</translation>
    </message>
    <message>
        <source>start and end swapped</source>
        <translation>zamiana startu i celu</translation>
    </message>
    <message>
        <source>start {port}</source>
        <translation>start {port}</translation>
    </message>
    <message>
        <source>yacht {name}</source>
        <translation>jacht {name}</translation>
    </message>
</context>
<context>
    <name>units</name>
    <message>
        <source>Bft</source>
        <translation>Bft</translation>
    </message>
    <message>
        <source>UTC</source>
        <translation>UTC</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>km</source>
        <translation>km</translation>
    </message>
    <message>
        <source>kn</source>
        <translation>kn</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>nm</source>
        <translation>Mm</translation>
    </message>
</context>
<context>
    <name>verdict</name>
    <message>
        <source>A day is enough, one way.</source>
        <translation>W jedną stronę wystarczy doba.</translation>
    </message>
    <message>
        <source>In this weather a day is enough, one way.</source>
        <translation>Przy tej pogodzie w jedną stronę wystarczy doba.</translation>
    </message>
    <message>
        <source>{d} d {h} h</source>
        <translation>{d} d {h} h</translation>
    </message>
    <message>
        <source>{h} h</source>
        <translation>{h} h</translation>
    </message>
    <message>
        <source>{takes}: a week is enough, one way, with {left} to spare.</source>
        <translation>{takes}: w jedną stronę tydzień wystarczy, zapas {left}.</translation>
    </message>
    <message>
        <source>{takes}: a week is hardly enough, {left} too long.</source>
        <translation>{takes}: tydzień raczej nie wystarczy, o {left} za długo.</translation>
    </message>
    <message>
        <source>{takes}: a week is not enough, {left} too long.</source>
        <translation>{takes}: tydzień nie wystarczy, o {left} za długo.</translation>
    </message>
    <message>
        <source>{takes}: a week is probably enough, one way, with {left} to spare.</source>
        <translation>{takes}: w jedną stronę tydzień prawdopodobnie wystarczy, zapas {left}.</translation>
    </message>
    <message>
        <source>{takes}: in this weather a week is enough, one way, with {left} to spare.</source>
        <translation>{takes}: przy tej pogodzie w jedną stronę tydzień wystarczy, zapas {left}.</translation>
    </message>
    <message>
        <source>{takes}: in this weather a week is not enough, {left} too long.</source>
        <translation>{takes}: przy tej pogodzie tydzień nie wystarczy, o {left} za długo.</translation>
    </message>
</context>
<context>
    <name>ways</name>
    <message numerus="yes">
        <source>%n turn(s) instead of {others}:</source>
        <translation>
            <numerusform>%n zwrot zamiast {others}:</numerusform>
            <numerusform>%n zwroty zamiast {others}:</numerusform>
            <numerusform>%n zwrotów zamiast {others}:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s):</source>
        <translation>
            <numerusform>%n zwrot:</numerusform>
            <numerusform>%n zwroty:</numerusform>
            <numerusform>%n zwrotów:</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer turns: {ways}. Click one on the chart, or choose it under Passage, Sail another way.</source>
        <translation>Mniej zwrotów: {ways}. Kliknij trasę na mapie albo wybierz ją w menu Trasa, Płyń inną drogą.</translation>
    </message>
    <message>
        <source>None on the chart: View, Other ways or Fewer turns</source>
        <translation>Na mapie nie ma żadnej: Widok, Inne drogi albo Mniej zwrotów</translation>
    </message>
    <message>
        <source>There is no passage with fewer tacks and gybes that is worth its time.</source>
        <translation>Nie ma trasy z mniejszą liczbą zwrotów, która byłaby warta swojego czasu.</translation>
    </message>
    <message>
        <source>direct</source>
        <translation>bezpośrednio</translation>
    </message>
    <message>
        <source>east of {island}</source>
        <translation>{island} od wschodu</translation>
    </message>
    <message>
        <source>leaving {moment}</source>
        <translation>wyjście {moment}</translation>
    </message>
    <message>
        <source>north of {island}</source>
        <translation>{island} od północy</translation>
    </message>
    <message>
        <source>south of {island}</source>
        <translation>{island} od południa</translation>
    </message>
    <message>
        <source>west of {island}</source>
        <translation>{island} od zachodu</translation>
    </message>
    <message>
        <source>{n} ({difference})</source>
        <translation>{n} ({difference})</translation>
    </message>
    <message>
        <source>{way} {duration}</source>
        <translation>{way} {duration}</translation>
    </message>
    <message>
        <source>{way}, {difference}</source>
        <translation>{way}, {difference}</translation>
    </message>
</context>
<context>
    <name>weather</name>
    <message>
        <source>Automatic</source>
        <translation>Automatycznie</translation>
    </message>
    <message>
        <source>Gives {what}</source>
        <translation>Daje: {what}</translation>
    </message>
    <message>
        <source>In the mean, with weight</source>
        <translation>Do średniej, z wagą</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>W użyciu</translation>
    </message>
    <message>
        <source>Kept: answers for {n} places, the latest {age} old</source>
        <translation>Przechowane odpowiedzi dla miejsc: {n}, najnowsza sprzed {age}</translation>
    </message>
    <message>
        <source>MET Norway</source>
        <translation>MET Norway</translation>
    </message>
    <message>
        <source>Nothing kept yet</source>
        <translation>Nic jeszcze nie przechowano</translation>
    </message>
    <message>
        <source>Open-Meteo</source>
        <translation>Open-Meteo</translation>
    </message>
    <message>
        <source>Open-Meteo ensemble</source>
        <translation>Open-Meteo, wiązka</translation>
    </message>
    <message>
        <source>Practice weather</source>
        <translation>Pogoda ćwiczebna</translation>
    </message>
    <message>
        <source>Sample of November 2016</source>
        <translation>Przykład z listopada 2016</translation>
    </message>
    <message>
        <source>Storm Glass</source>
        <translation>Storm Glass</translation>
    </message>
    <message>
        <source>Take off the list</source>
        <translation>Zdejmij z listy</translation>
    </message>
    <message>
        <source>Take {name} off the list</source>
        <translation>Zdejmij {name} z listy</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Użyj</translation>
    </message>
    <message>
        <source>Use {name}</source>
        <translation>Użyj: {name}</translation>
    </message>
    <message>
        <source>Weight of {name}</source>
        <translation>Waga: {name}</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>nie do użycia</translation>
    </message>
    <message>
        <source>current</source>
        <translation>prąd</translation>
    </message>
    <message>
        <source>every {n:g} h</source>
        <translation>co {n:g} h</translation>
    </message>
    <message>
        <source>gusts</source>
        <translation>porywy</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>w użyciu</translation>
    </message>
    <message>
        <source>members of an ensemble</source>
        <translation>człony wiązki</translation>
    </message>
    <message>
        <source>needs a key</source>
        <translation>wymaga klucza</translation>
    </message>
    <message>
        <source>not now</source>
        <translation>niedostępne</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nieosiągalne</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>wczytywanie…</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>gotowe</translation>
    </message>
    <message>
        <source>run of {moment}</source>
        <translation>przebieg z {moment}</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>rozrzut</translation>
    </message>
    <message>
        <source>waves</source>
        <translation>fale</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>wiatr</translation>
    </message>
    <message>
        <source>{n:g}° grid</source>
        <translation>siatka {n:g}°</translation>
    </message>
    <message>
        <source>{name} in the mean</source>
        <translation>{name} w średniej</translation>
    </message>
</context>
<context>
    <name>yachts</name>
    <message>
        <source> port</source>
        <translation> lewym halsem</translation>
    </message>
    <message>
        <source> starboard</source>
        <translation> prawym halsem</translation>
    </message>
    <message>
        <source>Beat</source>
        <translation>Ostro</translation>
    </message>
    <message>
        <source>Best beat {beat:.0f}°, VMG {up:.2f} kn.  Best run {run:.0f}°, VMG {down:.2f} kn.</source>
        <translation>Najlepsza halsówka {beat:.0f}°, VMG {up:.2f} kn.  Najlepszy pełny kurs {run:.0f}°, VMG {down:.2f} kn.</translation>
    </message>
    <message>
        <source>Boat speed on the beat [kn]</source>
        <translation>Prędkość jachtu w halsówce [kn]</translation>
    </message>
    <message>
        <source>Boat speed on the run [kn]</source>
        <translation>Prędkość jachtu na pełnym kursie [kn]</translation>
    </message>
    <message>
        <source>By how much her VMG on the beat is better than the other yacht&apos;s [kn]</source>
        <translation>O ile VMG tego jachtu w halsówce jest lepsze niż drugiego [kn]</translation>
    </message>
    <message>
        <source>By how much her VMG on the run is better than the other yacht&apos;s [kn]</source>
        <translation>O ile VMG tego jachtu na pełnym kursie jest lepsze niż drugiego [kn]</translation>
    </message>
    <message>
        <source>Fitted to {n} steady means of 10 s from {logs}.</source>
        <translation>Dopasowano do ustalonych średnich po 10 s w liczbie {n} z {logs}.</translation>
    </message>
    <message>
        <source>Made good against the wind [kn]</source>
        <translation>Zysk pod wiatr [kn]</translation>
    </message>
    <message>
        <source>Made good with the wind [kn]</source>
        <translation>Zysk z wiatrem [kn]</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Pełno</translation>
    </message>
    <message>
        <source>She is {percent:.1f} % faster on {tack} tack.</source>
        <translation>Jacht jest o {percent:.1f} % szybszy, gdy hals jest {tack}.</translation>
    </message>
    <message>
        <source>She sails {share:.1f} ± {error:.1f} % of the polar it was held against.</source>
        <translation>Jacht osiąga {share:.1f} ± {error:.1f} % biegunowej, z którą go porównano.</translation>
    </message>
    <message>
        <source>TWA {twa:.0f}°{tack}: {speed:.2f} kn</source>
        <translation>TWA {twa:.0f}°{tack}: {speed:.2f} kn</translation>
    </message>
    <message>
        <source>TWS</source>
        <translation>TWS</translation>
    </message>
    <message>
        <source>True wind angle of the best beat [degrees]</source>
        <translation>Kąt wiatru rzeczywistego najlepszej halsówki [stopnie]</translation>
    </message>
    <message>
        <source>True wind angle of the best run [degrees]</source>
        <translation>Kąt wiatru rzeczywistego najlepszego pełnego kursu [stopnie]</translation>
    </message>
    <message>
        <source>True wind speed [kn]</source>
        <translation>Prędkość wiatru rzeczywistego [kn]</translation>
    </message>
    <message>
        <source>VMG</source>
        <translation>VMG</translation>
    </message>
    <message>
        <source>VMG {vmg:.2f} kn to leeward</source>
        <translation>VMG {vmg:.2f} kn z wiatrem</translation>
    </message>
    <message>
        <source>VMG {vmg:.2f} kn to windward</source>
        <translation>VMG {vmg:.2f} kn pod wiatr</translation>
    </message>
    <message>
        <source>apparent {awa:.0f}°, {aws:.1f} kn</source>
        <translation>pozorny {awa:.0f}°, {aws:.1f} kn</translation>
    </message>
    <message>
        <source>gybing</source>
        <translation>zwroty przez rufę</translation>
    </message>
    <message>
        <source>kn</source>
        <translation>kn</translation>
    </message>
    <message>
        <source>port</source>
        <translation>lewy</translation>
    </message>
    <message>
        <source>starboard</source>
        <translation>prawy</translation>
    </message>
    <message>
        <source>tacking</source>
        <translation>halsówka</translation>
    </message>
    <message>
        <source>{how} at {angle:.0f}° makes good {made:.2f} kn that way.</source>
        <translation>{how} przy {angle:.0f}° daje w tę stronę {made:.2f} kn.</translation>
    </message>
    <message>
        <source>{one} and {two} by turns make good {made:.2f} kn that way.</source>
        <translation>{one} i {two} na przemian dają w tę stronę {made:.2f} kn.</translation>
    </message>
    <message>
        <source>± beat</source>
        <translation>± ostro</translation>
    </message>
    <message>
        <source>± run</source>
        <translation>± pełno</translation>
    </message>
</context>
</TS>
