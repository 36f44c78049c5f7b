<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_BR">
<context>
    <name>Archive</name>
    <message>
        <source>The file is empty</source>
        <translation>O arquivo está vazio</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>O arquivo não pode ser lido: %1</translation>
    </message>
    <message>
        <source>The file cannot be packed</source>
        <translation>O arquivo não pode ser compactado</translation>
    </message>
    <message>
        <source>The file does not exist</source>
        <translation>O arquivo não existe</translation>
    </message>
    <message>
        <source>This is not a Dipwright project, or the file is truncated or damaged</source>
        <translation>Isto não é um projeto do Dipwright, ou o arquivo está truncado ou danificado</translation>
    </message>
    <message>
        <source>The file is truncated or damaged</source>
        <translation>O arquivo está truncado ou danificado</translation>
    </message>
    <message>
        <source>The file contains an entry with an unsafe path and is not opened</source>
        <translation>O arquivo contém uma entrada com caminho inseguro e não foi aberto</translation>
    </message>
    <message>
        <source>The file contains the entry %1 twice</source>
        <translation>O arquivo contém a entrada %1 duas vezes</translation>
    </message>
    <message>
        <source>The file is encrypted; save it without a password</source>
        <translation>O arquivo está criptografado; salve-o sem senha</translation>
    </message>
    <message>
        <source>The project does not contain %1</source>
        <translation>O projeto não contém %1</translation>
    </message>
    <message>
        <source>%1 in the project is truncated or damaged</source>
        <translation>%1 no projeto está truncado ou danificado</translation>
    </message>
</context>
<context>
    <name>AtomicFile</name>
    <message>
        <source>it is a folder</source>
        <translation>é uma pasta</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>O arquivo não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>não é um arquivo comum</translation>
    </message>
    <message>
        <source>it is write-protected</source>
        <translation>está protegido contra gravação</translation>
    </message>
    <message>
        <source>another program is writing it now; try again</source>
        <translation>outro programa está gravando-o agora; tente de novo</translation>
    </message>
    <message>
        <source>its symbolic links form a loop</source>
        <translation>seus links simbólicos formam um ciclo</translation>
    </message>
    <message>
        <source>the disk did not accept its data: %1</source>
        <translation>o disco não aceitou os dados: %1</translation>
    </message>
</context>
<context>
    <name>BodyAppearance</name>
    <message>
        <source>Painted</source>
        <translation>Pintado</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Não pintado</translation>
    </message>
    <message>
        <source>Painted (estimated from the shape)</source>
        <translation>Pintado (estimado pela forma)</translation>
    </message>
</context>
<context>
    <name>BodyPath</name>
    <message>
        <source>A slanted dip needs an angle to the water between %1° and %2°</source>
        <translation>Uma imersão inclinada precisa de um ângulo com a água entre %1° e %2°</translation>
    </message>
    <message>
        <source>The part can enter tilted by at most 85°</source>
        <translation>A peça pode entrar tombada em 85° no máximo</translation>
    </message>
    <message>
        <source>slow at the beginning and the end</source>
        <translation>lenta no início e no fim</translation>
    </message>
    <message>
        <source>On its path the part travels more than %1 m; choose a smaller angle or water speed, or a faster dip</source>
        <translation>No percurso a peça avança mais de %1 m; escolha um ângulo ou uma velocidade da água menor, ou uma imersão mais rápida</translation>
    </message>
    <message>
        <source>slanted by %1°, heading %2°</source>
        <translation>tombada a %1°, direção %2°</translation>
    </message>
    <message>
        <source>tilted by %1°, heading %2°</source>
        <translation>tombada em %1°, direção %2°</translation>
    </message>
    <message>
        <source>rolled by %1°, heading %2°</source>
        <translation>rolada em %1°, direção %2°</translation>
    </message>
    <message>
        <source>turned by %1° on the way down</source>
        <translation>girada em %1° durante a descida</translation>
    </message>
    <message>
        <source>water at %1 mm/s, heading %2°</source>
        <translation>água a %1 mm/s, direção %2°</translation>
    </message>
    <message>
        <source>A path by poses needs at least two poses</source>
        <translation>Um percurso por poses precisa de pelo menos duas poses</translation>
    </message>
    <message>
        <source>The first pose of a path must have the time 0 s and the depth 0 mm, at which the part touches the water</source>
        <translation>A primeira pose de um percurso deve ter o tempo 0 s e a profundidade 0 mm, em que a peça toca a água</translation>
    </message>
    <message>
        <source>The last pose of a path must have the depth of the dip and no turn; to turn the part at the end of the dip, change its rotation</source>
        <translation>A última pose de um percurso deve ter a profundidade da imersão e nenhum giro; para girar a peça no fim da imersão, mude sua rotação</translation>
    </message>
    <message>
        <source>through %1 poses</source>
        <translation>por %1 poses</translation>
    </message>
    <message>
        <source>On its path the part travels and turns more than %1 m in all; use fewer poses or smaller turns</source>
        <translation>Em seu percurso a peça se move e gira mais de %1 m ao todo; use menos poses ou giros menores</translation>
    </message>
    <message>
        <source>acceleration at most %1 mm/s²</source>
        <translation>aceleração de no máximo %1 mm/s²</translation>
    </message>
    <message>
        <source>Pose %1 of the path must be at least %2 s later than the pose before it</source>
        <translation>A pose %1 do percurso deve vir pelo menos %2 s depois da pose anterior</translation>
    </message>
    <message>
        <source>The poses of the path turn the part too far in all; use fewer poses or smaller turns</source>
        <translation>As poses do percurso giram a peça demais ao todo; use menos poses ou giros menores</translation>
    </message>
    <message>
        <source>A part that rolls by more than 360° lays film on its own film; choose an angle of at most 360°</source>
        <translation>Uma peça que rola mais de 360° deita película sobre sua própria película; escolha um ângulo de no máximo 360°</translation>
    </message>
</context>
<context>
    <name>Certainty</name>
    <message>
        <source>Overhang (°)</source>
        <translation>Saliência (°)</translation>
    </message>
    <message>
        <source>Grip fade range (°)</source>
        <translation>Faixa em que a aderência diminui (°)</translation>
    </message>
    <message>
        <source>Gathering (mean stretch)</source>
        <translation>Franzimento (estiramento médio)</translation>
    </message>
    <message>
        <source>Tearing (stretch in length or area)</source>
        <translation>Rasgo (estiramento do comprimento ou da área)</translation>
    </message>
    <message>
        <source>%1 varied from %2 to %3 (in the project: %4): 95 % of the painted area moves by at most %5. %6 % of it moves by more than %7, and %8 % is no longer painted.</source>
        <translation>%1, variação de %2 a %3 (no projeto: %4): 95 % da área pintada se deslocam no máximo %5. %6 % dela se deslocam mais de %7, e %8 % deixam de ser pintados.</translation>
    </message>
    <message>
        <source>the film has too few points to be compared with a film of half as many</source>
        <translation>a película tem poucos pontos para ser comparada com uma película com metade dos pontos</translation>
    </message>
</context>
<context>
    <name>CheckedSolver</name>
    <message>
        <source>it threw an unknown exception</source>
        <translation>ele lançou uma exceção desconhecida</translation>
    </message>
    <message>
        <source>it reported impossible convergence values</source>
        <translation>ele informou valores de convergência impossíveis</translation>
    </message>
    <message>
        <source>it makes no progress</source>
        <translation>ele não avança</translation>
    </message>
    <message>
        <source>it stopped without being cancelled</source>
        <translation>ele parou sem ter sido cancelado</translation>
    </message>
    <message>
        <source>it returned no result for some films of a batch</source>
        <translation>ele não devolveu resultado para algumas películas de um lote</translation>
    </message>
    <message>
        <source>it created no film</source>
        <translation>ele não criou nenhuma película</translation>
    </message>
    <message>
        <source>it returned an invalid state for some points</source>
        <translation>ele devolveu um estado inválido para alguns pontos</translation>
    </message>
    <message>
        <source>it returned an invalid mark for some points</source>
        <translation>ele devolveu uma marca inválida para alguns pontos</translation>
    </message>
    <message>
        <source>it reported an impossible number of steps or an impossible descent</source>
        <translation>ele informou um número de passos impossível ou uma descida impossível</translation>
    </message>
</context>
<context>
    <name>ColourNote</name>
    <message>
        <source>%1 has colours outside BT.2020, the largest colour space used here: %2 % of its pixels are printed less saturated; to control this, save it in a smaller colour space, such as Adobe RGB</source>
        <translation>%1: há cores fora do BT.2020, o maior espaço de cor usado aqui; %2 % dos pixels são impressos menos saturados; para controlar isso, salve a imagem em um espaço de cor menor, como Adobe RGB</translation>
    </message>
    <message>
        <source>%1 is in CMYK and has no ICC profile, so its colours are only estimated and can be wrong; save it with its profile, or as sRGB</source>
        <translation>%1: imagem em CMYK sem perfil ICC, por isso as cores são só estimadas e podem estar erradas; salve-a com o seu perfil ou como sRGB</translation>
    </message>
    <message>
        <source>%1 is to be shown turned or mirrored, as its EXIF data says, but it is used as its pixels are stored; save it upright in an image program</source>
        <translation>%1 deve ser mostrada girada ou espelhada, segundo seus dados EXIF, mas é usada como seus pixels estão gravados; salve-a na posição correta em um programa de imagens</translation>
    </message>
    <message>
        <source>%1 names its colour space in a cICP chunk, which is not read, so its colours count as sRGB and can be wrong; save it with an ICC profile, or as sRGB</source>
        <translation>%1 indica seu espaço de cores em um bloco cICP, que não é lido; por isso as cores contam como sRGB e podem estar erradas; salve-a com um perfil ICC ou como sRGB</translation>
    </message>
</context>
<context>
    <name>Cost</name>
    <message>
        <source>Cyan</source>
        <translation>Ciano</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Amarelo</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Preto</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Ink: %1</source>
        <translation>Tinta: %1</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Trabalho</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Preparação</translation>
    </message>
    <message>
        <source>Handling</source>
        <translation>Manuseio</translation>
    </message>
    <message>
        <source>Soak</source>
        <translation>Deixar de molho</translation>
    </message>
    <message>
        <source>Activator</source>
        <translation>Ativador</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>Flash, each rack</source>
        <translation>Evaporação, cada suporte</translation>
    </message>
    <message>
        <source>Drying, each rack</source>
        <translation>Secagem, cada suporte</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>%1 m of roll</source>
        <translation>%1 m de rolo</translation>
    </message>
    <message>
        <source>%1 sheets</source>
        <translation>%1 folhas</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>no price</source>
        <translation>sem preço</translation>
    </message>
    <message>
        <source>no ml/m²</source>
        <translation>sem ml/m²</translation>
    </message>
    <message>
        <source>no time for the set-up</source>
        <translation>sem tempo de preparação</translation>
    </message>
    <message>
        <source>no time for handling</source>
        <translation>sem tempo de manuseio</translation>
    </message>
    <message>
        <source>no soak time</source>
        <translation>sem tempo de molho</translation>
    </message>
    <message>
        <source>no activator time</source>
        <translation>sem tempo do ativador</translation>
    </message>
    <message>
        <source>no flash time</source>
        <translation>sem tempo de evaporação</translation>
    </message>
    <message>
        <source>no drying time</source>
        <translation>sem tempo de secagem</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 days %2 h</source>
        <translation>%1 dias %2 h</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Soma</translation>
    </message>
    <message>
        <source>Sum of the known prices</source>
        <translation>Soma dos preços conhecidos</translation>
    </message>
    <message>
        <source>Working time</source>
        <translation>Tempo de trabalho</translation>
    </message>
    <message>
        <source>Until the last part is dry</source>
        <translation>Até a última peça secar</translation>
    </message>
    <message>
        <source>no price for the film</source>
        <translation>sem preço da película</translation>
    </message>
    <message>
        <source>no price for an hour of work</source>
        <translation>sem preço de uma hora de trabalho</translation>
    </message>
    <message>
        <source>no amount in ml/m² for ink: %1</source>
        <translation>sem quantidade em ml/m² de tinta: %1</translation>
    </message>
    <message>
        <source>no price for ink: %1</source>
        <translation>sem preço de tinta: %1</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>Peças: %1, folhas: %2</translation>
    </message>
    <message>
        <source>cost: %1, for each part: %2</source>
        <translation>custo: %1, por peça: %2</translation>
    </message>
    <message>
        <source>working time: %1, until the last part is dry: %2</source>
        <translation>tempo de trabalho: %1, até a última peça secar: %2</translation>
    </message>
</context>
<context>
    <name>Cradle</name>
    <message>
        <source>Forming the cradle</source>
        <translation>Formando o berço</translation>
    </message>
    <message>
        <source>Checking the cradle</source>
        <translation>Verificando o berço</translation>
    </message>
    <message>
        <source>%1: the part can slide sideways in its cradle, because its dry surface is too flat; mark its position and fix it there</source>
        <translation>%1: a peça pode escorregar de lado no seu berço, porque sua superfície seca é plana demais; marque a sua posição e fixe-a ali</translation>
    </message>
    <message>
        <source>%1: the cradle&apos;s plate has no room for the engraving; write the arrow, the dip number and the job on it</source>
        <translation>%1: a placa do berço não tem espaço para a gravação; escreva nela a seta, o número da imersão e o trabalho</translation>
    </message>
    <message>
        <source>%1: no cradle is possible, because an earlier dip has painted every place that could hold the part; allow padded contact with paint (cradle.on_paint), or turn the part</source>
        <translation>%1: nenhum berço é possível, porque uma imersão anterior pintou todos os lugares que poderiam segurar a peça; permita contato forrado com a tinta (cradle.on_paint) ou gire a peça</translation>
    </message>
    <message>
        <source>%1: no cradle is possible, because the film reaches every place that could hold the part; dip it less deep, or turn the part</source>
        <translation>%1: nenhum berço é possível, porque a película alcança todos os lugares que poderiam segurar a peça; mergulhe-a menos fundo ou gire a peça</translation>
    </message>
    <message>
        <source>Finding the surface that stays dry</source>
        <translation>Procurando a superfície que fica seca</translation>
    </message>
    <message>
        <source>%1: the part tips out of its cradle unless it is fastened, because the cradle cannot hold it on all sides of its centre of mass. Fasten the part through the bore in the cradle, or turn the part</source>
        <translation>%1: a peça tomba do berço se não for fixada, porque o berço não consegue segurá-la em todos os lados do centro de massa. Fixe a peça pelo furo do berço ou gire a peça</translation>
    </message>
    <message>
        <source>%1: the cradle touches %2 mm² of paint from an earlier dip; line the cradle there with %3 mm of soft felt or foam</source>
        <translation>%1: o berço toca %2 mm² de tinta de uma imersão anterior; forre o berço ali com %3 mm de feltro macio ou espuma</translation>
    </message>
    <message>
        <source>%1: no cradle is possible, because on this path it would touch the film on the water; tilt or roll the part less, dip it less deep, or hold it by hand</source>
        <translation>%1: nenhum berço é possível, porque neste percurso ele tocaria a película na água; tombe ou role menos a peça, mergulhe-a menos fundo ou segure-a com a mão</translation>
    </message>
    <message>
        <source>Reducing the triangles of the cradle</source>
        <translation>Reduzindo os triângulos do berço</translation>
    </message>
    <message>
        <source>%1: no cradle is possible, because the bore is wider than the place where the part rests; choose a smaller bore (cradle.bore_mm)</source>
        <translation>%1: nenhum berço é possível, porque o furo é mais largo do que o lugar onde a peça se apoia; escolha um furo menor (cradle.bore_mm)</translation>
    </message>
    <message>
        <source>%1: the model has %2 separate parts, but the cradle has one bore, which can fasten only one of them; give each part its own holder</source>
        <translation>%1: o modelo tem %2 peças separadas, mas o berço tem só um furo, que só consegue fixar uma delas; dê a cada peça o seu próprio suporte</translation>
    </message>
</context>
<context>
    <name>Dip</name>
    <message>
        <source>Dipping</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>The solver failed: %1</source>
        <translation>O solucionador falhou: %1</translation>
    </message>
    <message>
        <source>The solver failed with an unknown exception</source>
        <translation>O solucionador falhou com uma exceção desconhecida</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Torn film</source>
        <translation>Película rasgada</translation>
    </message>
    <message>
        <source>Film that did not converge</source>
        <translation>Película que não convergiu</translation>
    </message>
    <message>
        <source>Released film</source>
        <translation>Película solta</translation>
    </message>
    <message>
        <source>The part does not meet the film; move it over the film, choose a larger film, or give the film smaller cells or more points</source>
        <translation>A peça não encontra a película; mova-a sobre a película, escolha uma película maior ou dê à película células menores ou mais pontos</translation>
    </message>
    <message>
        <source>The solver did not find the part: it is only %1 mm thick in places, and the distance field has cells of %2 mm; make it thicker there, or dip only a section of it</source>
        <translation>O solucionador não encontrou a peça: ela tem só %1 mm de espessura em alguns lugares, e o campo de distância tem células de %2 mm; torne-a mais espessa ali ou mergulhe só uma seção dela</translation>
    </message>
    <message>
        <source>The part, %1 × %2 mm on the water, reaches past the film on all sides, so no film is left to wrap round it; %3</source>
        <translation>A peça, %1 × %2 mm sobre a água, ultrapassa a película em todos os lados, e não sobra película para envolvê-la; %3</translation>
    </message>
    <message>
        <source>With these cells the film would have %1 million points, but at most %2 million are allowed; choose larger cells</source>
        <translation>Com estas células a película teria %1 milhões de pontos, mas no máximo %2 milhões são permitidos; escolha células maiores</translation>
    </message>
    <message>
        <source>The simulation became unstable; choose a smaller step or time step (Dipping &gt; Accuracy)</source>
        <translation>A simulação ficou instável; escolha um passo ou um passo de tempo menor (Imersão &gt; Precisão)</translation>
    </message>
    <message>
        <source>%1 of the painted area (%2 %) is painted by film that tore, was released or did not converge. %3.</source>
        <translation>%1 da área pintada (%2 %) foram pintados por película que rasgou, se soltou ou não convergiu. %3.</translation>
    </message>
    <message>
        <source>This solver allows only straight dips; choose another solver, or a straight path</source>
        <translation>Este solucionador só permite imersões retas; escolha outro solucionador ou um percurso reto</translation>
    </message>
    <message>
        <source>The film model of the paper allows only straight dips; choose the production film, or a straight path</source>
        <translation>O modelo de película do artigo só permite imersões retas; escolha a película de produção ou um percurso reto</translation>
    </message>
    <message>
        <source>some places have several causes</source>
        <translation>alguns lugares têm várias causas</translation>
    </message>
    <message>
        <source>check the model&apos;s size and unit, because no film is larger than %1 mm</source>
        <translation>verifique o tamanho e a unidade do modelo, porque nenhuma película é maior que %1 mm</translation>
    </message>
    <message>
        <source>turn the film by 90° (%1 × %2 mm)</source>
        <translation>gire a película 90° (%1 × %2 mm)</translation>
    </message>
    <message>
        <source>choose a film that is clearly larger than %1 × %2 mm, because film also covers the part&apos;s sides</source>
        <translation>escolha uma película bem maior que %1 × %2 mm, porque ela também cobre os lados da peça</translation>
    </message>
</context>
<context>
    <name>DipCache</name>
    <message>
        <source>The file of cached dips is damaged and is ignored; the next run in the workbench replaces it</source>
        <translation>O arquivo de imersões em cache está danificado e é ignorado; a próxima execução na janela o substitui</translation>
    </message>
    <message>
        <source>The dips cannot be cached: %1</source>
        <translation>As imersões não podem ser guardadas em cache: %1</translation>
    </message>
    <message>
        <source>Reading the cached dips</source>
        <translation>Lendo as imersões em cache</translation>
    </message>
</context>
<context>
    <name>DipJob</name>
    <message>
        <source>Simulating the dip</source>
        <translation>Simulando a imersão</translation>
    </message>
    <message>
        <source>Preparing the views</source>
        <translation>Preparando as vistas</translation>
    </message>
    <message>
        <source>Refining the film</source>
        <translation>A película está sendo refinada</translation>
    </message>
</context>
<context>
    <name>DipPlayback</name>
    <message>
        <source>First contact</source>
        <translation>Primeiro contato</translation>
    </message>
    <message>
        <source>Film tears</source>
        <translation>A película rasga</translation>
    </message>
    <message>
        <source>Film is released at an overhang</source>
        <translation>A película se solta numa saliência</translation>
    </message>
    <message>
        <source>Air is trapped under the part</source>
        <translation>Ar fica preso sob a peça</translation>
    </message>
    <message>
        <source>%1, at depth %2</source>
        <translation>%1, a %2 de profundidade</translation>
    </message>
    <message>
        <source>Pose %1 of the path</source>
        <translation>Pose %1 do percurso</translation>
    </message>
</context>
<context>
    <name>FileLock</name>
    <message>
        <source>%1 on %2, process %3</source>
        <translation>%1 em %2, processo %3</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>outro programa</translation>
    </message>
    <message>
        <source>an unknown machine</source>
        <translation>uma máquina desconhecida</translation>
    </message>
</context>
<context>
    <name>FilmFacts</name>
    <message>
        <source>%1: cells of %2, %3 × %4 points</source>
        <translation>%1: células de %2, %3 × %4 pontos</translation>
    </message>
    <message>
        <source>%1, simulation time about %2 s</source>
        <translation>%1, tempo de simulação de cerca de %2 s</translation>
    </message>
</context>
<context>
    <name>FilmFields</name>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Livre</translation>
    </message>
    <message>
        <source>Held by a barrier</source>
        <translation>Preso por uma barreira</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Inchamento</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxação</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elástico</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Distância de contato</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Em cima</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Embaixo</translation>
    </message>
    <message>
        <source>C</source>
        <comment>cyan</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>M</source>
        <comment>magenta</comment>
        <translation>M</translation>
    </message>
    <message>
        <source>Y</source>
        <comment>yellow</comment>
        <translation>Y</translation>
    </message>
    <message>
        <source>K</source>
        <comment>black</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>W</source>
        <comment>white</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>As in the project</source>
        <translation>Como no projeto</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Saliência</translation>
    </message>
    <message>
        <source>Total growth of the floating film after a long time, relative to its length at the start of the dip. 0: the film does not grow.</source>
        <translation>Crescimento total da película flutuante depois de muito tempo, em relação ao comprimento no início da imersão. 0: a película não cresce.</translation>
    </message>
    <message>
        <source>Whether this side of the film floats freely or a barrier in the tank holds it.</source>
        <translation>Se este lado da película flutua livre ou se uma barreira no tanque o prende.</translation>
    </message>
    <message>
        <source>Size of the wetted film relative to the printed film, in width and height. The sheet is printed smaller by this factor, so measure it first.</source>
        <translation>Tamanho da película molhada em relação à impressa, na largura e na altura. A folha é impressa menor por este fator; por isso meça-o primeiro.</translation>
    </message>
    <message>
        <source>Time in which stress in the floating film decays. Elastic film keeps its stress for ever; viscous film (0 s) loses it at once.</source>
        <translation>Tempo em que a tensão na película flutuante diminui. Uma película elástica mantém a tensão para sempre; uma viscosa (0 s) a perde na hora.</translation>
    </message>
    <message>
        <source>Growth rate</source>
        <translation>Taxa de crescimento</translation>
    </message>
    <message>
        <source>How fast the floating film grows at the start of the dip, per second. Adhered film does not grow.</source>
        <translation>Com que rapidez a película flutuante cresce no início da imersão, por segundo. A película aderida não cresce.</translation>
    </message>
    <message>
        <source>Growth limit</source>
        <translation>Limite do crescimento</translation>
    </message>
    <message>
        <source>A film point touches the part when it comes this close to its surface.</source>
        <translation>Um ponto da película toca a peça quando chega a esta distância da superfície dela.</translation>
    </message>
    <message>
        <source>Ink exponent</source>
        <translation>Expoente da tinta</translation>
    </message>
    <message>
        <source>Ink exponent, black and white</source>
        <translation>Expoente da tinta, preto e branco</translation>
    </message>
    <message>
        <source>Measured ink</source>
        <translation>Tinta medida</translation>
    </message>
    <message>
        <source>Film tears where its length or its area is stretched by more than this factor. Torn film is marked and does not paint.</source>
        <translation>A película rasga onde seu comprimento ou sua área é esticado mais do que este fator. Película rasgada é marcada e não pinta.</translation>
    </message>
    <message>
        <source>Grip fade range</source>
        <translation>Faixa em que a aderência diminui</translation>
    </message>
    <message>
        <source>Gathering stretch</source>
        <translation>Estiramento de franzimento</translation>
    </message>
    <message>
        <source>Tear stretch</source>
        <translation>Estiramento de ruptura</translation>
    </message>
    <message>
        <source>The part loses its grip on the film gradually, in this range of angles before the overhang. This value is a guess; no film was measured.</source>
        <translation>A peça perde aos poucos a aderência à película nesta faixa de ângulos antes da saliência. Este valor é uma suposição; nenhuma película foi medida.</translation>
    </message>
    <message>
        <source>Compressed film gathers where its mean stretch falls below this value. Gathered film hardly resists further compression. This value is a guess; no film was measured.</source>
        <translation>A película comprimida franze onde seu estiramento médio cai abaixo deste valor. A película franzida quase não resiste a mais compressão. Este valor é uma suposição; nenhuma película foi medida.</translation>
    </message>
    <message>
        <source>How ink thins: where film is stretched to J times its area, ink of density D has only the density D·J^−n. n is 1 for dye and 0 for opaque dots. Used for inks without measured tones; the preset value is a guess.</source>
        <translation>Como a tinta afina: onde a película está esticada a J vezes sua área, tinta de densidade D fica só com a densidade D·J^−n. n é 1 para corante e 0 para pontos opacos. Usado para tintas sem tons medidos; o valor predefinido é uma suposição.</translation>
    </message>
    <message>
        <source>The exponent n for black and white ink. Only CMYK printers use it, because only for them each ink is compensated individually, after colour separation.</source>
        <translation>O expoente n para tinta preta e branca. Só impressoras CMYK o usam, porque só nelas cada tinta é compensada individualmente, depois da separação de cores.</translation>
    </message>
    <message>
        <source>Values for each tone of a measured step wedge: ink, density, exponent, bend and largest stretch. The command “dipwright-cli profile wedge” computes them.</source>
        <translation>Valores para cada tom de uma cunha de tons medida: tinta, densidade, expoente, curvatura e maior estiramento. O comando “dipwright-cli profile wedge” os calcula.</translation>
    </message>
    <message>
        <source>Film adheres to faces that turn up from the vertical by at most this angle. Faces that turn up more release the film.</source>
        <translation>A película adere a faces voltadas para cima em até este ângulo a partir da vertical. De faces mais voltadas para cima ela se solta.</translation>
    </message>
</context>
<context>
    <name>FilmMeasured</name>
    <message>
        <source>not measured</source>
        <translation>não medido</translation>
    </message>
    <message>
        <source>measured on %1</source>
        <translation>medido em %1</translation>
    </message>
    <message>
        <source>swell</source>
        <translation>inchamento</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>crescimento</translation>
    </message>
    <message>
        <source>relaxation</source>
        <translation>relaxação</translation>
    </message>
    <message>
        <source>%1 measured on %2</source>
        <translation>%1: medido em %2</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1: não medido</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>None (film not measured)</source>
        <translation>Nenhum (película não medida)</translation>
    </message>
</context>
<context>
    <name>FolderTransaction</name>
    <message>
        <source>The results cannot be written: %1</source>
        <translation>Os resultados não podem ser gravados: %1</translation>
    </message>
    <message>
        <source>The results cannot be written, because %1 is not a folder</source>
        <translation>Os resultados não podem ser gravados, porque %1 não é uma pasta</translation>
    </message>
    <message>
        <source>Another program is writing results to this folder (%1); wait for it, or choose another folder</source>
        <translation>Outro programa está gravando resultados nesta pasta (%1); espere por ele ou escolha outra pasta</translation>
    </message>
    <message>
        <source>The folder cannot be written; choose another folder</source>
        <translation>Não é possível gravar na pasta; escolha outra pasta</translation>
    </message>
    <message>
        <source>The results are incomplete, because files in %1 were moved or removed during writing; leave that folder alone and try again</source>
        <translation>Os resultados estão incompletos, porque arquivos em %1 foram movidos ou removidos durante a gravação; não mexa nessa pasta e tente de novo</translation>
    </message>
    <message>
        <source>The results cannot be moved into the folder, perhaps because a file there is in use; close it and try again</source>
        <translation>Os resultados não podem ser movidos para a pasta, talvez porque um arquivo ali esteja em uso; feche-o e tente de novo</translation>
    </message>
    <message>
        <source>Only some of the results were moved into the folder; close the programs that have files there open, then start this program again to move the rest</source>
        <translation>Só uma parte dos resultados foi movida para a pasta; feche os programas que têm arquivos abertos ali e inicie este programa de novo para mover o resto</translation>
    </message>
    <message>
        <source>Earlier results in this folder are incomplete, and another program prevents their completion. Close the programs that use files in the folder, or move %1 out of the folder</source>
        <translation>Resultados anteriores nesta pasta estão incompletos, e outro programa impede que sejam completados. Feche os programas que usam arquivos da pasta ou mova %1 para fora dela</translation>
    </message>
    <message>
        <source>Results that were just written cannot be read: %1</source>
        <translation>Os resultados recém-gravados não podem ser lidos: %1</translation>
    </message>
    <message>
        <source>The results cannot be written, because %1 already exists and cannot be replaced; move it, or choose another folder</source>
        <translation>Os resultados não podem ser gravados, porque %1 já existe e não pode ser substituído; mova-o ou escolha outra pasta</translation>
    </message>
    <message>
        <source>The results cannot be written: their folder was removed or moved meanwhile</source>
        <translation>Não é possível gravar os resultados: a pasta foi removida ou movida nesse meio-tempo</translation>
    </message>
</context>
<context>
    <name>GuidePlaces</name>
    <message>
        <source>Dip ▸ Tolerances</source>
        <translation>Imersão ▸ Tolerâncias</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Meio</translation>
    </message>
    <message>
        <source>timeline</source>
        <translation>linha do tempo</translation>
    </message>
    <message>
        <source>File ▸ Print</source>
        <translation>Arquivo ▸ Imprimir</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>perfil ICC</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramento</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Prova</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Folha</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>Edit ▸ Profiles</source>
        <translation>Editar ▸ Perfis</translation>
    </message>
    <message>
        <source>Measuring a dipped part</source>
        <translation>Medir uma peça mergulhada</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Measuring a film</source>
        <translation>Medir uma película</translation>
    </message>
    <message>
        <source>File ▸ Snapshots</source>
        <translation>Arquivo ▸ Instantâneos</translation>
    </message>
    <message>
        <source>log</source>
        <translation>registro</translation>
    </message>
    <message>
        <source>Dip ▸ Check numerical error</source>
        <translation>Imersão ▸ Verificar erro numérico</translation>
    </message>
    <message>
        <source>File ▸ New project</source>
        <translation>Arquivo ▸ Novo projeto</translation>
    </message>
    <message>
        <source>Reload model</source>
        <translation>Recarregar modelo</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Emenda</translation>
    </message>
    <message>
        <source>Dip ▸ Find poses</source>
        <translation>Imersão ▸ Procurar poses</translation>
    </message>
    <message>
        <source>File ▸ Print history</source>
        <translation>Arquivo ▸ Histórico de impressão</translation>
    </message>
    <message>
        <source>File ▸ Calibrate printer</source>
        <translation>Arquivo ▸ Calibrar impressora</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Como saiu</translation>
    </message>
    <message>
        <source>File ▸ Job queue</source>
        <translation>Arquivo ▸ Fila de trabalhos</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>No tanque</translation>
    </message>
    <message>
        <source>File ▸ Plates</source>
        <translation>Arquivo ▸ Chapas</translation>
    </message>
    <message>
        <source>Dip ▸ Send to server</source>
        <translation>Imersão ▸ Enviar ao servidor</translation>
    </message>
</context>
<context>
    <name>ImmersionEdits</name>
    <message>
        <source>Add dip</source>
        <translation>Adicionar imersão</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>Remove dip</source>
        <translation>Remover imersão</translation>
    </message>
    <message>
        <source>Use pose</source>
        <translation>Usar pose</translation>
    </message>
    <message>
        <source>Swap dips</source>
        <translation>Trocar imersões</translation>
    </message>
    <message>
        <source>Try poses</source>
        <translation>Experimentar poses</translation>
    </message>
    <message>
        <source>Add pose to path</source>
        <translation>Adicionar pose ao percurso</translation>
    </message>
    <message>
        <source>Remove pose from path</source>
        <translation>Remover pose do percurso</translation>
    </message>
</context>
<context>
    <name>InkOptions</name>
    <message>
        <source>Comparing the options for ink</source>
        <translation>Comparando as opções para a tinta</translation>
    </message>
    <message>
        <source>Lighten the darkest colours to density %1</source>
        <translation>Clarear as cores mais escuras até a densidade %1</translation>
    </message>
    <message>
        <source>Print white beneath the colours</source>
        <translation>Imprimir branco sob as cores</translation>
    </message>
    <message>
        <source>Print the ink in %1 passes</source>
        <translation>Imprimir a tinta em %1 passadas</translation>
    </message>
    <message>
        <source>Search for a pose with less stretch</source>
        <translation>Buscar uma pose com menos estiramento</translation>
    </message>
    <message>
        <source>%1 % of the painted surface too pale; missing density where it is short now: %2 (95 %), %3 at most; mean colour error ΔE %4</source>
        <translation>%1 % da superfície pintada clara demais; densidade que falta onde não basta agora: %2 (95 %), no máximo %3; erro de cor médio ΔE %4</translation>
    </message>
    <message>
        <source>; %1 % of the contrast there</source>
        <translation>; %1 % do contraste ali</translation>
    </message>
    <message>
        <source>ink suffices where the area of the film grows at most %1 times</source>
        <translation>a tinta basta onde a área da película cresce no máximo %1 vezes</translation>
    </message>
</context>
<context>
    <name>InspectionEdits</name>
    <message>
        <source>Measured %1</source>
        <translation>Medido em %1</translation>
    </message>
    <message>
        <source>Add photos</source>
        <translation>Adicionar fotos</translation>
    </message>
    <message>
        <source>Remove photo</source>
        <translation>Remover foto</translation>
    </message>
    <message>
        <source>Add pair of places</source>
        <translation>Adicionar par de pontos</translation>
    </message>
    <message>
        <source>Move place in photo</source>
        <translation>Mover ponto na foto</translation>
    </message>
    <message>
        <source>Remove pair of places</source>
        <translation>Remover par de pontos</translation>
    </message>
    <message>
        <source>Keep part</source>
        <translation>Guardar peça</translation>
    </message>
    <message>
        <source>Correct the next sheets</source>
        <translation>Corrigir as próximas folhas</translation>
    </message>
    <message>
        <source>Change strength of correction</source>
        <translation>Alterar intensidade da correção</translation>
    </message>
    <message>
        <source>Change film measurement</source>
        <translation>Alterar medição da película</translation>
    </message>
    <message>
        <source>Use fit in project</source>
        <translation>Usar ajuste no projeto</translation>
    </message>
</context>
<context>
    <name>InspectionProfile</name>
    <message>
        <source>Save to profile</source>
        <translation>Salvar no perfil</translation>
    </message>
    <message>
        <source>Name of a new or existing film profile</source>
        <translation>Nome de um perfil de película novo ou existente</translation>
    </message>
    <message>
        <source>Saved the measurement in the film profile %1</source>
        <translation>Medição salva no perfil de película %1</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Artwork</source>
        <translation>Arte</translation>
    </message>
    <message>
        <source>Pose search</source>
        <translation>Busca de poses</translation>
    </message>
</context>
<context>
    <name>MarkEdits</name>
    <message>
        <source>Mark zone</source>
        <translation>Marcar zona</translation>
    </message>
    <message>
        <source>Remove mark</source>
        <translation>Remover marca</translation>
    </message>
    <message>
        <source>Remove marks</source>
        <translation>Remover marcas</translation>
    </message>
    <message>
        <source>Mark area for the seam</source>
        <translation>Marcar área para a emenda</translation>
    </message>
    <message>
        <source>Erase marks for the seam</source>
        <translation>Apagar marcas para a emenda</translation>
    </message>
    <message>
        <source>Erase mask</source>
        <translation>Apagar máscara</translation>
    </message>
    <message>
        <source>Mask area</source>
        <translation>Mascarar área</translation>
    </message>
    <message>
        <source>The project holds as many marks of this kind as it can; remove some to mark more</source>
        <translation>O projeto contém o máximo de marcações deste tipo; remova algumas para marcar mais</translation>
    </message>
</context>
<context>
    <name>Mask</name>
    <message>
        <source>Masked areas: %1 (%2 mm²). Cover them with tape before the first dip.</source>
        <translation>Áreas mascaradas: %1 (%2 mm²). Cubra-as com fita antes da primeira imersão.</translation>
    </message>
</context>
<context>
    <name>ModelEdits</name>
    <message>
        <source>Change size</source>
        <translation>Mudar tamanho</translation>
    </message>
</context>
<context>
    <name>ModelImport</name>
    <message>
        <source>Reading the model</source>
        <translation>Lendo o modelo</translation>
    </message>
    <message>
        <source>Reading the texture</source>
        <translation>Lendo a textura</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>The model refers to files outside its folder:</source>
        <translation>O modelo se refere a arquivos fora da sua pasta:</translation>
    </message>
    <message>
        <source>Reload model</source>
        <translation>Recarregar modelo</translation>
    </message>
    <message>
        <source>The project file refers to these files:</source>
        <translation>O arquivo do projeto se refere a estes arquivos:</translation>
    </message>
    <message>
        <source>Replace model</source>
        <translation>Trocar modelo</translation>
    </message>
    <message>
        <source>Replace texture</source>
        <translation>Trocar textura</translation>
    </message>
    <message>
        <source>Change tolerance</source>
        <translation>Alterar tolerância</translation>
    </message>
    <message>
        <source>Making the triangles again</source>
        <translation>Refazendo os triângulos</translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>The motion template contains the unknown placeholder {%1}; use one of these: %2</source>
        <translation>O modelo do movimento contém o marcador desconhecido {%1}; use um destes: %2</translation>
    </message>
    <message>
        <source>This dip follows a path, and the motion template has no {moves}; add {moves} or {moves_per_minute}, or choose the template of a controller: linuxcnc, grbl or marlin</source>
        <translation>Esta imersão segue um percurso, mas o modelo de movimento não contém {moves}; acrescente {moves} ou {moves_per_minute}, ou escolha o modelo de um controlador: linuxcnc, grbl ou marlin</translation>
    </message>
</context>
<context>
    <name>OutOfProcessSolver</name>
    <message>
        <source>its process cannot be started: %1</source>
        <translation>o processo dele não pode ser iniciado: %1</translation>
    </message>
    <message>
        <source>it did not respond for %1 s and was stopped</source>
        <translation>ele não respondeu por %1 s e foi encerrado</translation>
    </message>
    <message>
        <source>its answer was impossibly long, so its process was stopped</source>
        <translation>a resposta dele era longa demais, por isso o processo dele foi encerrado</translation>
    </message>
    <message>
        <source>its process was killed, perhaps because the memory was full</source>
        <translation>o processo dele foi encerrado à força, talvez porque a memória estava cheia</translation>
    </message>
    <message>
        <source>it crashed (code %1)</source>
        <translation>ele parou por uma falha (código %1)</translation>
    </message>
    <message>
        <source>its process ended unexpectedly (exit code %1)</source>
        <translation>o processo dele terminou inesperadamente (código de saída %1)</translation>
    </message>
</context>
<context>
    <name>OutputSets</name>
    <message>
        <source>Sheets as PDF</source>
        <translation>Folhas em PDF</translation>
    </message>
    <message>
        <source>Film images as PNG</source>
        <translation>Imagens da película em PNG</translation>
    </message>
    <message>
        <source>Sheets in the printer&apos;s colours as PDF</source>
        <translation>Folhas nas cores da impressora em PDF</translation>
    </message>
    <message>
        <source>Sheets in the printer&apos;s colours as TIFF</source>
        <translation>Folhas nas cores da impressora em TIFF</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Prova</translation>
    </message>
    <message>
        <source>Traveller</source>
        <translation>Ficha de acompanhamento</translation>
    </message>
    <message>
        <source>Motion programs</source>
        <translation>Programas de movimento</translation>
    </message>
    <message>
        <source>Cradles</source>
        <translation>Berços</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>Film and part for ParaView</source>
        <translation>Película e peça para ParaView</translation>
    </message>
    <message>
        <source>Maps of the film</source>
        <translation>Mapas da película</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Tudo</translation>
    </message>
    <message>
        <source>Print shop</source>
        <translation>Gráfica</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Tanque</translation>
    </message>
    <message>
        <source>There is no output set of this name; the project has %1. A list of outputs is also possible: %2</source>
        <translation>Não há conjunto de saídas com este nome; o projeto tem %1. Também é possível uma lista de saídas: %2</translation>
    </message>
    <message>
        <source>Proof to share</source>
        <translation>Prova para compartilhar</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Cliente</translation>
    </message>
</context>
<context>
    <name>Outputs</name>
    <message>
        <source>Writing the sheet of %1</source>
        <translation>Gravando a folha de %1</translation>
    </message>
    <message>
        <source>The folder cannot be created; choose another one</source>
        <translation>A pasta não pode ser criada; escolha outra</translation>
    </message>
    <message>
        <source>These files were not made by an output or were changed since: %1. Allow overwriting, or choose another folder</source>
        <translation>Estes arquivos não foram gerados por uma saída ou foram alterados depois: %1. Permita sobrescrever ou escolha outra pasta</translation>
    </message>
    <message>
        <source>%1: done, %2</source>
        <translation>%1: pronto, %2</translation>
    </message>
    <message>
        <source>%1: failed. %2</source>
        <translation>%1: falhou. %2</translation>
    </message>
    <message>
        <source>%1: out of date</source>
        <translation>%1: desatualizado</translation>
    </message>
    <message>
        <source>%1: not made</source>
        <translation>%1: não gerado</translation>
    </message>
</context>
<context>
    <name>PhysicsValidation</name>
    <message>
        <source>%1 film, %2 cells in the contact radius</source>
        <translation>película %1, %2 células no raio de contato</translation>
    </message>
    <message>
        <source>arc length from the pole (mm)</source>
        <translation>comprimento de arco desde o polo (mm)</translation>
    </message>
    <message>
        <source>film radius (mm)</source>
        <translation>raio da película (mm)</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corpo</translation>
    </message>
    <message>
        <source>film</source>
        <translation>película</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>células</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>média</translation>
    </message>
    <message>
        <source>max</source>
        <translation>máx</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>passos</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>FAILED</source>
        <translation>FALHOU</translation>
    </message>
    <message>
        <source>Dipping</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>The solver failed: %1</source>
        <translation>O solucionador falhou: %1</translation>
    </message>
    <message>
        <source>physics validation</source>
        <translation>validação da física</translation>
    </message>
    <message>
        <source>Flat spheroid 1 : 0.6</source>
        <translation>Esferoide achatado 1 : 0,6</translation>
    </message>
    <message>
        <source>Long spheroid 1 : 1.4</source>
        <translation>Esferoide alongado 1 : 1,4</translation>
    </message>
    <message>
        <source>Cone of %1°</source>
        <translation>Cone de %1°</translation>
    </message>
    <message>
        <source>viscous</source>
        <translation>viscosa</translation>
    </message>
    <message>
        <source>elastic</source>
        <translation>elástica</translation>
    </message>
    <message>
        <source>Flat face, 60 × 40 mm</source>
        <translation>Face plana, 60 × 40 mm</translation>
    </message>
    <message>
        <source>Ellipsoid turned by 45°</source>
        <translation>Elipsoide girado de 45°</translation>
    </message>
    <message>
        <source>%1, %2 cells</source>
        <translation>%1, %2 células</translation>
    </message>
    <message>
        <source>Flat face</source>
        <translation>Face plana</translation>
    </message>
    <message>
        <source>free</source>
        <translation>livre</translation>
    </message>
    <message>
        <source>growing</source>
        <translation>em crescimento</translation>
    </message>
    <message>
        <source>Film before it is touched</source>
        <translation>Película antes do contato</translation>
    </message>
    <message>
        <source>The film never touched the body; do not use this solver</source>
        <translation>A película nunca tocou o corpo; não use este solucionador</translation>
    </message>
    <message>
        <source>axes − diagonals</source>
        <translation>eixos − diagonais</translation>
    </message>
    <message>
        <source>Inner side of a torus, up to 80° from its lowest circle</source>
        <translation>Lado interno de um toro, até 80° do seu círculo mais baixo</translation>
    </message>
    <message>
        <source>Sphere, up to 80° from its lowest point</source>
        <translation>Esfera, até 80° do seu ponto mais baixo</translation>
    </message>
    <message>
        <source>Horizontal cylinder, up to 80° from its lowest line</source>
        <translation>Cilindro horizontal, até 80° da sua linha mais baixa</translation>
    </message>
</context>
<context>
    <name>Pipeline</name>
    <message>
        <source>a film with coarser cells does not follow the part</source>
        <translation>uma película com células maiores não acompanha a peça</translation>
    </message>
    <message>
        <source>Writing the sheet of %1</source>
        <translation>Gravando a folha de %1</translation>
    </message>
    <message>
        <source>Writing the film of %1</source>
        <translation>Gravando a película de %1</translation>
    </message>
    <message>
        <source>Comparing the sheets</source>
        <translation>Comparando as folhas</translation>
    </message>
    <message>
        <source>Writing the proof</source>
        <translation>Gravando a prova</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Gravando o relatório</translation>
    </message>
    <message>
        <source>Reversing the texture</source>
        <translation>Revertendo a textura</translation>
    </message>
    <message>
        <source>Dipping with varied film laws</source>
        <translation>Imersão com leis da película variadas</translation>
    </message>
    <message>
        <source>Writing the cradle of %1</source>
        <translation>Gravando o berço de %1</translation>
    </message>
    <message>
        <source>Writing the traveller</source>
        <translation>Gravando a ficha de acompanhamento</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Writing film %1</source>
        <translation>Gravando a película %1</translation>
    </message>
    <message>
        <source>The picture on the film</source>
        <translation>A imagem na película</translation>
    </message>
    <message>
        <source>1:1, reduced for swell %1 × %2</source>
        <translation>1:1, reduzido pelo inchamento %1 × %2</translation>
    </message>
    <message>
        <source>Locating the film on the part</source>
        <translation>Localizando a película na peça</translation>
    </message>
    <message>
        <source>%1 should be dipped after %2. Along the seam, the film&apos;s stretch is %3 for %1 and %4 for %2. A placement error of the second film grows with its stretch.</source>
        <translation>%1 deveria ser mergulhado depois de %2. Ao longo da emenda, o estiramento da película é %3 em %1 e %4 em %2. Um erro de posição da segunda película cresce com o estiramento dela.</translation>
    </message>
    <message>
        <source>The project has no model; import one first</source>
        <translation>O projeto não tem modelo; importe um primeiro</translation>
    </message>
    <message>
        <source>The run needs about %1 GB of memory for the sheets</source>
        <translation>A execução precisa de cerca de %1 GB de memória para as folhas</translation>
    </message>
    <message>
        <source>The sheets need about %1 GB of memory, but this computer has %2 GB; choose a lower resolution or a smaller film</source>
        <translation>As folhas precisam de cerca de %1 GB de memória, mas este computador tem %2 GB; escolha uma resolução menor ou uma película menor</translation>
    </message>
    <message>
        <source>The part does not meet the film; move it over the film or choose a larger film</source>
        <translation>A peça não encontra a película; mova-a sobre a película ou escolha uma película maior</translation>
    </message>
    <message>
        <source>The part is smaller than the film&apos;s cells; give the film smaller cells or more points, or check the model&apos;s unit</source>
        <translation>A peça é menor que as células da película; dê à película células menores ou mais pontos, ou verifique a unidade do modelo</translation>
    </message>
    <message>
        <source>%1: the film&apos;s cells are too coarse for this part; give the film smaller cells or more points</source>
        <translation>%1: as células da película são grandes demais para esta peça; dê à película células menores ou mais pontos</translation>
    </message>
    <message>
        <source>Import of the model: %1</source>
        <translation>Importação do modelo: %1</translation>
    </message>
    <message>
        <source>The model is not closed; Dipwright guesses what is inside</source>
        <translation>O modelo não é fechado; o Dipwright estima o que é interior</translation>
    </message>
    <message>
        <source>Writing the motion files</source>
        <translation>Gravando os arquivos de movimento</translation>
    </message>
    <message>
        <source>Writing the coverage picture</source>
        <translation>Gravando a imagem de cobertura</translation>
    </message>
    <message>
        <source>Simulating a deeper dip</source>
        <translation>Simulando uma imersão mais profunda</translation>
    </message>
    <message>
        <source>%1: the film&apos;s cells were reduced to %2 mm.</source>
        <translation>%1: as células da película foram reduzidas para %2 mm.</translation>
    </message>
    <message>
        <source>%1: cells of %2 mm might be small enough to print the sheet, but would need about %3 million points × steps; the project allows %4 million. Raise this limit (Film &gt; Work limit), or turn the part.</source>
        <translation>%1: com células de %2 mm a folha talvez possa ser impressa, mas seriam necessários cerca de %3 milhões de pontos × passos; o projeto permite %4 milhões. Aumente este limite (Película &gt; Limite de trabalho) ou gire a peça.</translation>
    </message>
    <message>
        <source>Film %1: %2 × %3 mm, pieces: %4, used area: %5 %</source>
        <translation>Película %1: %2 × %3 mm, pedaços: %4, área usada: %5 %</translation>
    </message>
    <message>
        <source>Moving the results to their folder</source>
        <translation>Movendo os resultados para a pasta deles</translation>
    </message>
    <message>
        <source>The artwork has %1 spot colours, more than the limit of %2; remove some</source>
        <translation>A arte tem %1 cores especiais, mais que o limite de %2; remova algumas</translation>
    </message>
    <message>
        <source>The simulation became unstable when this setting was varied; give the film smaller cells or more points</source>
        <translation>A simulação ficou instável quando esta configuração foi variada; dê à película células menores ou mais pontos</translation>
    </message>
    <message>
        <source>Some places of the model are only %1 mm thick. The film may miss them, because the smallest possible cells of the distance field are %2 mm. Make these places thicker, or dip a smaller section of the model.</source>
        <translation>Alguns lugares do modelo têm só %1 mm de espessura. A película pode não os encontrar, porque as menores células possíveis do campo de distância têm %2 mm. Torne esses lugares mais espessos ou mergulhe uma seção menor do modelo.</translation>
    </message>
    <message>
        <source>The model is inside out, at least in some places. Film does not adhere to faces that point inwards. Import the model again; the import turns these faces outwards.</source>
        <translation>O modelo está virado do avesso, pelo menos em alguns lugares. A película não adere a faces voltadas para dentro. Importe o modelo de novo; a importação vira essas faces para fora.</translation>
    </message>
    <message>
        <source>The check of the numerical error would need a film of %1 × %2 points, which is too many; halve the number of film points</source>
        <translation>A verificação do erro numérico precisaria de uma película de %1 × %2 pontos, o que é demais; reduza à metade o número de pontos da película</translation>
    </message>
    <message>
        <source>The CPU is used instead of %1, which is not available: %2</source>
        <translation>A CPU é usada em vez de %1, que não está disponível: %2</translation>
    </message>
    <message>
        <source>%2 took over, because %1 failed: %3</source>
        <translation>%2 assumiu, porque %1 falhou: %3</translation>
    </message>
    <message>
        <source>The model has no texture; the colours of its materials are printed</source>
        <translation>O modelo não tem textura; são impressas as cores dos seus materiais</translation>
    </message>
    <message>
        <source>The part reaches past the film&apos;s edge; move or turn the part, or %1</source>
        <translation>A peça ultrapassa a borda da película; mova ou gire a peça, ou %1</translation>
    </message>
    <message>
        <source>Writing the stretch maps of %1</source>
        <translation>Gravando os mapas de estiramento de %1</translation>
    </message>
    <message>
        <source>Writing the tolerance map of %1</source>
        <translation>Gravando o mapa de tolerâncias de %1</translation>
    </message>
    <message>
        <source>there is too little memory</source>
        <translation>a memória não é suficiente</translation>
    </message>
    <message>
        <source>%1: the dip could not be repeated with smaller cells: %2</source>
        <translation>%1: a imersão não pôde ser repetida com células menores: %2</translation>
    </message>
    <message>
        <source>The film model of the paper allows only straight dips; choose the production film, or a straight path</source>
        <translation>O modelo de película do artigo só permite imersões retas; escolha a película de produção ou um percurso reto</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>There is nothing to write</source>
        <translation>Não há nada para gravar</translation>
    </message>
    <message>
        <source>The white ink and the cut contour are both named %1; rename one of them under Sheet, Spot colours</source>
        <translation>O branco e o contorno de corte se chamam ambos %1; mude o nome de um deles em Folha, Cores especiais</translation>
    </message>
    <message>
        <source>The layer&apos;s spot colour has the name of the sheet&apos;s white ink, %1; give the layer another spot colour, or rename the white ink under Sheet, Spot colours</source>
        <translation>A cor especial da camada tem o nome do branco da folha, %1; dê à camada outra cor especial ou mude o nome do branco em Folha, Cores especiais</translation>
    </message>
    <message>
        <source>The layer&apos;s spot colour has the name of the cut contour, %1; give the layer another spot colour, or rename the cut contour under Sheet, Spot colours</source>
        <translation>A cor especial da camada tem o nome do contorno de corte, %1; dê à camada outra cor especial ou mude o nome do contorno em Folha, Cores especiais</translation>
    </message>
    <message>
        <source>The spot colours %1 and %2 differ only in capital letters; write both alike, or give the layer another spot colour</source>
        <translation>As cores especiais %1 e %2 diferem só nas maiúsculas; escreva as duas do mesmo modo ou dê à camada outra cor especial</translation>
    </message>
    <message>
        <source>A zone, mask or layer names the face or material “%1”, which the model does not have; choose another name</source>
        <translation>Uma zona, máscara ou camada indica a face ou o material “%1”, que o modelo não tem; escolha outro nome</translation>
    </message>
    <message>
        <source>Writing the proof to share</source>
        <translation>Gravando a prova para compartilhar</translation>
    </message>
    <message>
        <source>The dips were simulated on another computer by %1, which is not available here. Run the job here before you compute tolerances</source>
        <translation>As imersões foram simuladas em outro computador com %1, que não está disponível aqui. Execute o trabalho aqui antes de calcular tolerâncias</translation>
    </message>
    <message>
        <source>The jobs differ in their ink settings or CMYK profiles, so that the films do not keep all amounts of ink of CMYK pictures or compensate each ink by itself; give all jobs the same ink settings and profiles</source>
        <translation>Os trabalhos diferem nas configurações de tinta ou nos perfis CMYK, de modo que as películas não mantêm todas as quantidades de tinta das imagens CMYK ou não compensam cada tinta por si; dê a todos os trabalhos as mesmas configurações de tinta e os mesmos perfis</translation>
    </message>
    <message>
        <source>%1: the sheet can be printed, but its numerical error is above the wanted error. Cells of %2 mm might reach it, with about %3 million points × steps; the project allows %4 million (Film &gt; Work limit).</source>
        <translation>%1: a folha pode ser impressa, mas seu erro numérico é maior que o desejado. Células de %2 mm talvez atinjam o erro desejado, com cerca de %3 milhões de pontos × passos; o projeto permite %4 milhões (Película &gt; Limite de trabalho).</translation>
    </message>
    <message>
        <source>Fins or pins of the model, %1 mm² in all, are at most %2 mm thick. The film may miss them, because the cells of the distance field are %3 mm. Increase the resolution of the distance field, or make these places thicker.</source>
        <translation>Aletas ou pinos do modelo, %1 mm² ao todo, têm no máximo %2 mm de espessura. A película pode não encontrá-los, porque as células do campo de distância têm %3 mm. Aumente a resolução do campo de distância ou torne esses pontos mais espessos.</translation>
    </message>
    <message>
        <source>The film of this job swells, relaxes or grows differently from that of %1; pack only jobs for the same film together</source>
        <translation>A película deste trabalho incha, relaxa ou cresce de outro modo que a de %1; junte só trabalhos para a mesma película</translation>
    </message>
    <message>
        <source>This job has another printer profile than %1; give both the same profile (on the command line, --profile gives it to all jobs)</source>
        <translation>Este trabalho tem outro perfil de impressora que %1; dê a ambos o mesmo perfil (na linha de comando, --profile o dá a todos os trabalhos)</translation>
    </message>
    <message>
        <source>Masks that lie off the part: %1. Perhaps they were made for another model; draw them again</source>
        <translation>Máscaras fora da peça: %1. Talvez tenham sido feitas para outro modelo; desenhe-as de novo</translation>
    </message>
    <message>
        <source>Zones that lie off the part: %1. Perhaps they were made for another model; mark them again</source>
        <translation>Zonas fora da peça: %1. Talvez tenham sido feitas para outro modelo; marque-as de novo</translation>
    </message>
    <message>
        <source>Marks for the seam that lie off the part: %1. Perhaps they were made for another model; mark the seam again</source>
        <translation>Marcações da emenda fora da peça: %1. Talvez tenham sido feitas para outro modelo; marque a emenda de novo</translation>
    </message>
</context>
<context>
    <name>PlainFile</name>
    <message>
        <source>it is a folder</source>
        <translation>é uma pasta</translation>
    </message>
    <message>
        <source>it is a pipe or a device; save its data to a file and choose that file</source>
        <translation>é um pipe ou um dispositivo; salve os dados em um arquivo e escolha esse arquivo</translation>
    </message>
</context>
<context>
    <name>Png</name>
    <message>
        <source>The picture cannot be stored as PNG: %1</source>
        <translation>A imagem não pode ser guardada como PNG: %1</translation>
    </message>
    <message>
        <source>The picture cannot be stored as PNG, because it is empty or too large for this computer&apos;s memory</source>
        <translation>A imagem não pode ser guardada como PNG, porque está vazia ou é grande demais para a memória deste computador</translation>
    </message>
</context>
<context>
    <name>PoseSearch</name>
    <message>
        <source>Trying poses</source>
        <translation>Testando poses</translation>
    </message>
    <message>
        <source>Choose a number from %1 to %2</source>
        <translation>Escolha um número de %1 a %2</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualidade</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Maior estiramento</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Ar preso</translation>
    </message>
    <message>
        <source>Film used</source>
        <translation>Película usada</translation>
    </message>
    <message>
        <source>weight of a zone</source>
        <translation>peso de uma zona</translation>
    </message>
    <message>
        <source>Narrow overlap</source>
        <translation>Sobreposição estreita</translation>
    </message>
    <message>
        <source>The project has no model; import one first</source>
        <translation>O projeto não tem modelo; importe um primeiro</translation>
    </message>
    <message>
        <source>Rating directions by the part&apos;s shape</source>
        <translation>Avaliando direções pela forma da peça</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>no difference</source>
        <translation>nenhuma diferença</translation>
    </message>
    <message>
        <source>%1 (worse)</source>
        <translation>%1 (pior)</translation>
    </message>
    <message>
        <source>%1 (better)</source>
        <translation>%1 (melhor)</translation>
    </message>
    <message>
        <source>There is no measure with this name; choose one of %1</source>
        <translation>Não há medida com este nome; escolha uma de %1</translation>
    </message>
    <message>
        <source>Film without faults</source>
        <translation>Película sem falhas</translation>
    </message>
    <message>
        <source>Wrinkled film</source>
        <translation>Película enrugada</translation>
    </message>
    <message>
        <source>Torn film</source>
        <translation>Película rasgada</translation>
    </message>
    <message>
        <source>Seam length</source>
        <translation>Comprimento da emenda</translation>
    </message>
    <message>
        <source>All weights are 0; set at least one weight above 0</source>
        <translation>Todos os pesos são 0; defina pelo menos um peso acima de 0</translation>
    </message>
    <message>
        <source>This file holds a part of another search; create all files from the same project with the same options and solver</source>
        <translation>Este arquivo contém uma parte de outra busca; crie todos os arquivos a partir do mesmo projeto, com as mesmas opções e o mesmo solucionador</translation>
    </message>
    <message>
        <source>search part %1 of %2</source>
        <translation>parte %1 de %2 da busca</translation>
    </message>
    <message>
        <source>Give each of the %1 result files of the divided search exactly once; you gave %2 files</source>
        <translation>Informe cada um dos %1 arquivos de resultado da busca dividida exatamente uma vez; foram informados %2 arquivos</translation>
    </message>
    <message>
        <source>This file does not contain all dips of its part of the search; create it again</source>
        <translation>Este arquivo não contém todas as imersões da sua parte da busca; crie-o de novo</translation>
    </message>
    <message>
        <source>None of the simulated poses paints the part; choose a larger film</source>
        <translation>Nenhuma das poses simuladas pinta a peça; escolha uma película maior</translation>
    </message>
    <message>
        <source>This file holds no part of a pose search, or it is damaged; create it again with --shard</source>
        <translation>Este arquivo não contém uma parte de uma busca de poses ou está danificado; crie-o de novo com --shard</translation>
    </message>
    <message>
        <source>Paths need the production film and a solver that follows them; choose another solver, or search without paths</source>
        <translation>Percursos precisam da película de produção e de um solucionador que os siga; escolha outro solucionador ou busque sem percursos</translation>
    </message>
    <message>
        <source>Dip %1: %2</source>
        <translation>Imersão %1: %2</translation>
    </message>
    <message>
        <source>The whole part is masked; unmask the surface to be printed before you search for a pose</source>
        <translation>A peça inteira está mascarada; retire a máscara da superfície a imprimir antes de procurar uma pose</translation>
    </message>
    <message>
        <source>Dipping the best pose with smaller cells</source>
        <translation>Mergulhando a melhor pose com células menores</translation>
    </message>
    <message>
        <source>This part of a pose search is from another version of the program; create it again with --shard</source>
        <translation>Esta parte de uma busca de poses é de outra versão do programa; crie-a novamente com --shard</translation>
    </message>
</context>
<context>
    <name>ProfileSpecs</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Livre</translation>
    </message>
    <message>
        <source>Held by a barrier</source>
        <translation>Preso por uma barreira</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Em cima</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Embaixo</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Margens</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left</comment>
        <translation>E</translation>
    </message>
    <message>
        <source>T</source>
        <comment>top</comment>
        <translation>S</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right</comment>
        <translation>D</translation>
    </message>
    <message>
        <source>B</source>
        <comment>bottom</comment>
        <translation>I</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolução</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Cor</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>Intenção de renderização</translation>
    </message>
    <message>
        <source>Perceptual</source>
        <translation>Perceptual</translation>
    </message>
    <message>
        <source>Relative colorimetric</source>
        <translation>Colorimétrico relativo</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturação</translation>
    </message>
    <message>
        <source>Absolute colorimetric</source>
        <translation>Colorimétrico absoluto</translation>
    </message>
    <message>
        <source>Ink limit</source>
        <translation>Limite de tinta</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Alimentação</translation>
    </message>
    <message>
        <source>Short edge first</source>
        <translation>Borda curta primeiro</translation>
    </message>
    <message>
        <source>Long edge first</source>
        <translation>Borda longa primeiro</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>Lote</translation>
    </message>
    <message>
        <source>Behaviour on the water</source>
        <translation>Comportamento na água</translation>
    </message>
    <message>
        <source>Soak time</source>
        <translation>Tempo de molho</translation>
    </message>
    <message>
        <source>Activator time</source>
        <translation>Tempo do ativador</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Lados</translation>
    </message>
    <message>
        <source>L</source>
        <comment>length</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Nível da água</translation>
    </message>
    <message>
        <source>Barriers</source>
        <translation>Barreiras</translation>
    </message>
    <message>
        <source>Whether a barrier in the tank holds this side of the film.</source>
        <translation>Se uma barreira no tanque prende este lado da película.</translation>
    </message>
    <message>
        <source>Flash time</source>
        <translation>Tempo de evaporação</translation>
    </message>
    <message>
        <source>Not given</source>
        <translation>Não informado</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>Tempo de secagem</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>Medido em</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Resíduo</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>The name of the profile in lists and projects.</source>
        <translation>O nome do perfil em listas e projetos.</translation>
    </message>
    <message>
        <source>System name</source>
        <translation>Nome no sistema</translation>
    </message>
    <message>
        <source>The printer&apos;s name in the operating system. The print dialog selects this printer first.</source>
        <translation>O nome da impressora no sistema operacional. A caixa de impressão seleciona primeiro esta impressora.</translation>
    </message>
    <message>
        <source>Pixels per inch of the sheets for this printer.</source>
        <translation>Pixels por polegada das folhas para esta impressora.</translation>
    </message>
    <message>
        <source>How out-of-gamut colours are mapped to colours that the printer can print.</source>
        <translation>Como as cores fora da gama são convertidas em cores que a impressora consegue imprimir.</translation>
    </message>
    <message>
        <source>Black point compensation</source>
        <translation>Compensação de ponto preto</translation>
    </message>
    <message>
        <source>The highest optical density per channel that the film holds.</source>
        <translation>A maior densidade óptica por canal que a película suporta.</translation>
    </message>
    <message>
        <source>Total area coverage</source>
        <translation>Cobertura total de tinta</translation>
    </message>
    <message>
        <source>From the ICC profile</source>
        <translation>Do perfil ICC</translation>
    </message>
    <message>
        <source>Measured from photos</source>
        <translation>Medido por fotos</translation>
    </message>
    <message>
        <source>The date of the photos. The profile counts as measured as long as swell and growth have the values from the photos.</source>
        <translation>A data das fotos. O perfil conta como medido enquanto inchamento e crescimento tiverem os valores das fotos.</translation>
    </message>
    <message>
        <source>Water temperature, °C</source>
        <translation>Temperatura da água, °C</translation>
    </message>
    <message>
        <source>The temperature of the water in the photos.</source>
        <translation>A temperatura da água nas fotos.</translation>
    </message>
    <message>
        <source>Measured swell</source>
        <translation>Inchamento medido</translation>
    </message>
    <message>
        <source>Swell error</source>
        <translation>Erro do inchamento</translation>
    </message>
    <message>
        <source>Measured growth</source>
        <translation>Crescimento medido</translation>
    </message>
    <message>
        <source>The growth measured from the photos.</source>
        <translation>O crescimento medido nas fotos.</translation>
    </message>
    <message>
        <source>The limit of the growth, measured from the photos.</source>
        <translation>O limite do crescimento, medido nas fotos.</translation>
    </message>
    <message>
        <source>Measured relaxation</source>
        <translation>Relaxação medida</translation>
    </message>
    <message>
        <source>The relaxation time measured from photos of a dipped part.</source>
        <translation>O tempo de relaxação medido em fotos de uma peça mergulhada.</translation>
    </message>
    <message>
        <source>The SHA-256 checksums of the photo files, to identify them.</source>
        <translation>As somas SHA-256 dos arquivos das fotos, para identificá-los.</translation>
    </message>
    <message>
        <source>The edge that enters the printer first. Film swells more along its web.</source>
        <translation>A borda que entra primeiro na impressora. A película incha mais ao longo da bobina.</translation>
    </message>
    <message>
        <source>The manufacturer&apos;s lot number. Another lot may swell differently.</source>
        <translation>O número do lote do fabricante. Outro lote pode inchar de outro modo.</translation>
    </message>
    <message>
        <source>A date such as 2027-03-31. May be empty.</source>
        <translation>Uma data como 2027-03-31. Pode ficar vazia.</translation>
    </message>
    <message>
        <source>Time from the dip to the rinse.</source>
        <translation>Tempo da imersão ao enxágue.</translation>
    </message>
    <message>
        <source>Time from the rinse until the part may be touched or dipped again.</source>
        <translation>Tempo do enxágue até a peça poder ser tocada ou mergulhada de novo.</translation>
    </message>
    <message>
        <source>Distance from the tank&apos;s rim down to the water.</source>
        <translation>Distância da borda do tanque até a água.</translation>
    </message>
    <message>
        <source>Mark spacing</source>
        <translation>Distância entre marcas</translation>
    </message>
    <message>
        <source>The margins that the printer cannot reach at the left (L), top (T), right (R) and bottom (B) edge of the paper.</source>
        <translation>As margens que a impressora não alcança na borda esquerda (E), superior (S), direita (D) e inferior (I) do papel.</translation>
    </message>
    <message>
        <source>The swell measured from the photos, in width (W) and height (H). 0: not measured.</source>
        <translation>O inchamento medido nas fotos, na largura (L) e na altura (A). 0: não medido.</translation>
    </message>
    <message>
        <source>Uncertainty of the measured swell (±, 95 % confidence), in width (W) and height (H).</source>
        <translation>Incerteza do inchamento medido (±, confiança de 95 %), na largura (L) e na altura (A).</translation>
    </message>
    <message>
        <source>Width (W) and height (H) of the dry film.</source>
        <translation>Largura (L) e altura (A) da película seca.</translation>
    </message>
    <message>
        <source>Advanced: material laws that are not measured</source>
        <translation>Avançado: leis do material não medidas</translation>
    </message>
    <message>
        <source>Width (W) and length (L) of the water surface.</source>
        <translation>Largura (L) e comprimento (C) da superfície da água.</translation>
    </message>
    <message>
        <source>Distance between the tank&apos;s marks, across (X) and along (Y) the tank. The sheet&apos;s registration marks are aligned with the tank&apos;s marks. 0: no marks.</source>
        <translation>Distância entre as marcas do tanque, na largura (X) e no comprimento (Y) do tanque. As marcas de registro da folha são alinhadas com as marcas do tanque. 0: sem marcas.</translation>
    </message>
    <message>
        <source>Printed length divided by intended length, across the paper (X) and along its feed (Y). Sheets are divided by this factor, so that they print at true size. “Calibrate printer” measures the factor.</source>
        <translation>Comprimento impresso dividido pelo comprimento desejado, na largura do papel (X) e ao longo do avanço (Y). As folhas são divididas por este fator, para que saiam em tamanho real. “Calibrar impressora” mede o fator.</translation>
    </message>
    <message>
        <source>Maps the darkest colour of the image to the darkest colour that the printer can print, so that shadows stay distinct.</source>
        <translation>Converte a cor mais escura da imagem na cor mais escura que a impressora consegue imprimir, para que as sombras continuem distintas.</translation>
    </message>
    <message>
        <source>The largest sum of the four inks at one place (TAC). Where the sum is larger, cyan, magenta and yellow are reduced; black stays. Used only with a CMYK ICC profile.</source>
        <translation>A maior soma das quatro tintas em um lugar (TAC). Onde a soma é maior, ciano, magenta e amarelo são reduzidos; o preto fica. Usada só com um perfil ICC em CMYK.</translation>
    </message>
    <message>
        <source>Measured growth limit</source>
        <translation>Limite do crescimento medido</translation>
    </message>
    <message>
        <source>Average distance between the corners of the printed squares in the photos and their positions computed from these values.</source>
        <translation>Distância média entre os cantos dos quadrados impressos nas fotos e as posições deles calculadas a partir destes valores.</translation>
    </message>
    <message>
        <source>Use by</source>
        <translation>Válido até</translation>
    </message>
    <message>
        <source>Time from laying the film on the water to spraying the activator.</source>
        <translation>Tempo desde que a película é posta na água até borrifar o ativador.</translation>
    </message>
    <message>
        <source>Time from spraying the activator to the dip.</source>
        <translation>Tempo desde que o ativador é borrifado até a imersão.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Water depth</source>
        <translation>Profundidade da água</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>How far the machine can move the centre of a part sideways from the middle of the tank.</source>
        <translation>Até que distância do meio do tanque a máquina pode mover o centro de uma peça para o lado.</translation>
    </message>
    <message>
        <source>Fastest motion</source>
        <translation>Movimento mais rápido</translation>
    </message>
    <message>
        <source>The highest speed at which the machine moves a part.</source>
        <translation>A maior velocidade com que a máquina move uma peça.</translation>
    </message>
    <message>
        <source>Fastest turn</source>
        <translation>Giro mais rápido</translation>
    </message>
    <message>
        <source>The highest speed at which the machine turns a part.</source>
        <translation>A maior velocidade com que a máquina gira uma peça.</translation>
    </message>
    <message>
        <source>Distance from the water surface to the tank&apos;s floor. The verdict on a dip that goes deeper is “Do not print”.</source>
        <translation>Distância da superfície da água ao fundo do tanque. O veredito de uma imersão mais funda é “Não imprimir”.</translation>
    </message>
    <message>
        <source>Cost of the ink</source>
        <translation>Custo da tinta</translation>
    </message>
    <message>
        <source>C</source>
        <comment>cyan</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>M</source>
        <comment>magenta</comment>
        <translation>M</translation>
    </message>
    <message>
        <source>Y</source>
        <comment>yellow</comment>
        <translation>Y</translation>
    </message>
    <message>
        <source>K</source>
        <comment>black</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Branco</translation>
    </message>
    <message>
        <source>Other</source>
        <comment>spot inks</comment>
        <translation>Outras</translation>
    </message>
    <message>
        <source>Ink at full tint, ml/m²</source>
        <translation>Tinta a 100 %, ml/m²</translation>
    </message>
    <message>
        <source>Millilitres of each ink on a square metre that is printed at full tint. Usual values are 5 to 20. 0: not given.</source>
        <translation>Mililitros de cada tinta em um metro quadrado impresso a 100 %. Valores usuais: 5 a 20. 0: não informado.</translation>
    </message>
    <message>
        <source>Price of a litre</source>
        <translation>Preço de um litro</translation>
    </message>
    <message>
        <source>Price of a litre of each ink, in the currency of the tank&apos;s profile. 0: not given.</source>
        <translation>Preço de um litro de cada tinta, na moeda do perfil do tanque. 0: não informado.</translation>
    </message>
    <message>
        <source>Spot ink at full tint, ml/m²</source>
        <translation>Tinta especial a 100 %, ml/m²</translation>
    </message>
    <message>
        <source>The same for white and for every other spot ink. 0: not given.</source>
        <translation>O mesmo para o branco e para cada outra tinta especial. 0: não informado.</translation>
    </message>
    <message>
        <source>Price of a litre of spot ink</source>
        <translation>Preço de um litro de tinta especial</translation>
    </message>
    <message>
        <source>The price of white and of every other spot ink. 0: not given.</source>
        <translation>Preço do branco e de cada outra tinta especial. 0: não informado.</translation>
    </message>
    <message>
        <source>Cost of the film</source>
        <translation>Custo da película</translation>
    </message>
    <message>
        <source>Price</source>
        <translation>Preço</translation>
    </message>
    <message>
        <source>Price of the film for the unit below, in the currency of the tank&apos;s profile.</source>
        <translation>Preço da película para a unidade abaixo, na moeda do perfil do tanque.</translation>
    </message>
    <message>
        <source>Price for</source>
        <translation>Preço por</translation>
    </message>
    <message>
        <source>What the price is for. A metre of roll is as wide as the film is cut.</source>
        <translation>A que se refere o preço. Um metro de rolo tem a largura em que a película é cortada.</translation>
    </message>
    <message>
        <source>A square metre</source>
        <translation>Um metro quadrado</translation>
    </message>
    <message>
        <source>A metre of roll</source>
        <translation>Um metro de rolo</translation>
    </message>
    <message>
        <source>A sheet</source>
        <translation>Uma folha</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Trabalho</translation>
    </message>
    <message>
        <source>Price of an hour</source>
        <translation>Preço de uma hora</translation>
    </message>
    <message>
        <source>Price of an hour of work at the tank. Set-up, handling, soak, activator and dip count as work; flash and drying do not.</source>
        <translation>Preço de uma hora de trabalho no tanque. Preparação, manuseio, molho, ativador e imersão contam como trabalho; evaporação e secagem, não.</translation>
    </message>
    <message>
        <source>Set-up, minutes</source>
        <translation>Preparação, minutos</translation>
    </message>
    <message>
        <source>Minutes of work before the first dip of an order.</source>
        <translation>Minutos de trabalho antes da primeira imersão de um pedido.</translation>
    </message>
    <message>
        <source>Handling, minutes</source>
        <translation>Manuseio, minutos</translation>
    </message>
    <message>
        <source>Minutes of work for each dip of a rack, in addition to the timed steps: laying the film, mounting, rinsing.</source>
        <translation>Minutos de trabalho em cada imersão de um suporte, além dos passos cronometrados: pôr a película, montar, enxaguar.</translation>
    </message>
    <message>
        <source>Parts per rack</source>
        <translation>Peças por suporte</translation>
    </message>
    <message>
        <source>How many parts one dip with one sheet makes. More than 1 only if the model shows several parts on a jig.</source>
        <translation>Quantas peças uma imersão com uma folha faz. Mais de 1 só se o modelo mostra várias peças em um suporte.</translation>
    </message>
    <message>
        <source>Scrap</source>
        <translation>Refugo</translation>
    </message>
    <message>
        <source>Share of the dipped racks that cannot be sold. Film, ink and work are counted for them, too. Usual values are 2 to 10 %.</source>
        <translation>Parte dos suportes mergulhados que não pode ser vendida. Película, tinta e trabalho contam também para eles. Valores usuais: 2 a 10 %.</translation>
    </message>
    <message>
        <source>Currency</source>
        <translation>Moeda</translation>
    </message>
    <message>
        <source>The currency of all prices, for example EUR.</source>
        <translation>A moeda de todos os preços, por exemplo BRL.</translation>
    </message>
    <message>
        <source>PDF and TIFF files</source>
        <translation>Arquivos PDF e TIFF</translation>
    </message>
    <message>
        <source>PDF for</source>
        <translation>PDF para</translation>
    </message>
    <message>
        <source>The RIP that reads the CMYK PDF. For Ghostscript, white and spot colours blend as transparency, which looks right on every screen, too. For the Adobe PDF Print Engine they overprint. For older RIPs they overprint in a PDF/X-1a file. Viewers that ignore overprint show white over the colours.</source>
        <translation>O RIP que lê o PDF em CMYK. Para o Ghostscript, o branco e as cores especiais se sobrepõem como transparência, o que também aparece certo em qualquer tela. Para o Adobe PDF Print Engine eles sobreimprimem. Para RIPs mais antigos eles sobreimprimem em um arquivo PDF/X-1a. Visualizadores que ignoram a sobreimpressão mostram o branco sobre as cores.</translation>
    </message>
    <message>
        <source>Ghostscript, viewers</source>
        <translation>Ghostscript, visualizadores</translation>
    </message>
    <message>
        <source>Adobe PDF Print Engine</source>
        <translation>Adobe PDF Print Engine</translation>
    </message>
    <message>
        <source>Older RIPs</source>
        <translation>RIPs mais antigos</translation>
    </message>
    <message>
        <source>Square pixels in TIFF</source>
        <translation>Pixels quadrados no TIFF</translation>
    </message>
    <message>
        <source>Gives TIFF files one resolution. If the scales X and Y differ, the image is resampled, which softens it slightly. Without this, the file has two resolutions, which some RIPs ignore.</source>
        <translation>Dá aos arquivos TIFF uma só resolução. Se as escalas X e Y forem diferentes, a imagem é reamostrada, o que a suaviza um pouco. Sem isto, o arquivo tem duas resoluções, que alguns RIPs ignoram.</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rolo</translation>
    </message>
    <message>
        <source>Gap in a series</source>
        <translation>Espaço em uma série</translation>
    </message>
    <message>
        <source>Bare film between the sheets of a series, which is printed on the roll as one job, with cut marks and the number of each copy in the gap. Usual values are 5 to 20 mm. Without it, each sheet is a page of its own.</source>
        <translation>Película livre entre as folhas de uma série, que é impressa no rolo em um só trabalho, com marcas de corte e o número de cada cópia no espaço. Valores usuais são de 5 a 20 mm. Sem ele, cada folha é uma página própria.</translation>
    </message>
    <message>
        <source>Single pages</source>
        <translation>Páginas separadas</translation>
    </message>
    <message>
        <source>Width of the roll</source>
        <translation>Largura do rolo</translation>
    </message>
    <message>
        <source>Width of the loaded roll, as far as it can be printed. Give it if the printer does not report its roll.</source>
        <translation>Largura do rolo carregado, até onde pode ser impresso. Indique-a se a impressora não informa o seu rolo.</translation>
    </message>
    <message>
        <source>As the printer reports</source>
        <translation>Como a impressora informa</translation>
    </message>
    <message>
        <source>Pure inks</source>
        <translation>Tintas puras</translation>
    </message>
    <message>
        <source>As the ICC profile mixes them</source>
        <translation>Como o perfil ICC as mistura</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Preto</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>What is printed in one ink alone instead of a mixture. “Black”: greys of RGB pictures, and black alone in CMYK pictures. “All”: cyan, magenta and yellow alone, too. Keeps text and lines sharp. CMYK pictures in the printer&apos;s own ICC profile always keep their amounts of ink, unless a device link from CMYK converts them.</source>
        <translation>O que é impresso em uma única tinta em vez de uma mistura. “Preto”: cinzas de imagens RGB e preto puro em imagens CMYK. “Todas”: também ciano, magenta e amarelo puros. Mantém textos e linhas nítidos. Imagens CMYK no perfil ICC da própria impressora sempre mantêm suas quantidades de tinta, a menos que um device link de CMYK as converta.</translation>
    </message>
</context>
<context>
    <name>Profiles</name>
    <message>
        <source>%1, lot %2,</source>
        <translation>%1, lote %2,</translation>
    </message>
    <message>
        <source>This is not a Dipwright profile</source>
        <translation>Isto não é um perfil do Dipwright</translation>
    </message>
    <message>
        <source>A profile needs a name</source>
        <translation>Um perfil precisa de um nome</translation>
    </message>
    <message>
        <source>The profile cannot be removed</source>
        <translation>O perfil não pode ser removido</translation>
    </message>
    <message>
        <source>This is not a Dipwright profile: %1</source>
        <translation>Isto não é um perfil do Dipwright: %1</translation>
    </message>
    <message>
        <source>The profile cannot be written: %1</source>
        <translation>O perfil não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>The ICC profile is not valid base64 text; import it again</source>
        <translation>O perfil ICC não é um texto base64 válido; importe-o de novo</translation>
    </message>
    <message>
        <source>The profile has version %1 of the file format, but this program reads only up to version %2; open it with a newer Dipwright</source>
        <translation>O perfil tem a versão %1 do formato, mas este programa lê só até a versão %2; abra-o com um Dipwright mais novo</translation>
    </message>
    <message>
        <source>Another program is writing the profile (%1); try again</source>
        <translation>Outro programa está gravando o perfil (%1); tente de novo</translation>
    </message>
    <message>
        <source>A file of this name exists and is not a readable profile, so it is not replaced; repair it, move it, or choose another name: %1</source>
        <translation>Existe um arquivo com este nome que não pode ser lido como perfil, por isso não é substituído; corrija-o, mova-o ou escolha outro nome: %1</translation>
    </message>
    <message>
        <source>Another program has changed the profile since it was read, so it is not saved; read it again and repeat your change</source>
        <translation>Outro programa mudou o perfil desde que foi lido, por isso não é salvo; leia-o de novo e repita sua mudança</translation>
    </message>
    <message>
        <source>The folder for profiles cannot be created; choose another with DIPWRIGHT_PROFILE_PATH</source>
        <translation>A pasta de perfis não pode ser criada; escolha outra com DIPWRIGHT_PROFILE_PATH</translation>
    </message>
    <message>
        <source>There is no such kind of profile; use printer, film or tank</source>
        <translation>Não há esse tipo de perfil; use printer, film ou tank</translation>
    </message>
    <message>
        <source>This profile has no value of this name; choose one of: %1</source>
        <translation>Este perfil não tem valor com este nome; escolha um de: %1</translation>
    </message>
    <message>
        <source>There is no %1 profile of this name; choose one of: %2</source>
        <translation>Não há perfil de %1 com este nome; escolha um de: %2</translation>
    </message>
    <message>
        <source>You have no %1 profile of this name; profiles that come with the program cannot be removed</source>
        <translation>Você não tem perfil de %1 com este nome; os perfis que vêm com o programa não podem ser removidos</translation>
    </message>
    <message>
        <source>The film %1 expired on %2; use a new lot, or test this lot first</source>
        <translation>A película %1 venceu em %2; use um lote novo ou teste primeiro este lote</translation>
    </message>
    <message>
        <source>Several files hold a %1 profile of this name, and only the first is read: %2; remove all but one, or change the name in the others</source>
        <translation>Vários arquivos contêm um perfil (%1) com este nome, e só o primeiro é lido: %2; remova todos menos um ou mude o nome nos outros</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>a text of at most %1 characters</source>
        <translation>um texto de no máximo %1 caracteres</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>um de %1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>um número de %1 a %2</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>um número inteiro de %1 a %2</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>uma lista</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>um objeto</translation>
    </message>
    <message>
        <source>“%1” must be an object</source>
        <translation>“%1” deve ser um objeto</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 deve ser um objeto</translation>
    </message>
    <message>
        <source>profiles.%1 holds a profile of another kind</source>
        <translation>profiles.%1 contém um perfil de outro tipo</translation>
    </message>
    <message>
        <source>This is not a Dipwright project</source>
        <translation>Isto não é um projeto do Dipwright</translation>
    </message>
    <message>
        <source>%1 must be an array of at most %2 entries</source>
        <translation>%1 deve ser uma lista de no máximo %2 itens</translation>
    </message>
    <message>
        <source>a colour such as #1a2b3c</source>
        <translation>uma cor como #1a2b3c</translation>
    </message>
    <message>
        <source>A value is missing; expected %1</source>
        <translation>Falta um valor; esperado: %1</translation>
    </message>
    <message>
        <source>%1 is not allowed here; expected %2</source>
        <translation>%1 não é permitido aqui; esperado: %2</translation>
    </message>
    <message>
        <source>There is no film size of this name; use one of %1</source>
        <translation>Não há tamanho de película com este nome; use um de %1</translation>
    </message>
    <message>
        <source>immersions must be an array with one or two entries</source>
        <translation>immersions deve ser uma lista de uma ou duas entradas</translation>
    </message>
    <message>
        <source>The project has version %1 of the file format, but this program reads only up to version %2; open it with a newer Dipwright</source>
        <translation>O projeto tem a versão %1 do formato, mas este programa lê só até a versão %2; abra-o com um Dipwright mais novo</translation>
    </message>
    <message>
        <source>There is no such setting; %1</source>
        <translation>Essa configuração não existe; %1</translation>
    </message>
    <message>
        <source>There is no preset %1; use production or paper-2020</source>
        <translation>Não há predefinição %1; use production ou paper-2020</translation>
    </message>
    <message>
        <source>There is no such layer; the number of layers is %1, and the lowest is artwork.layers[0]</source>
        <translation>Essa camada não existe; o número de camadas é %1, e a mais baixa é artwork.layers[0]</translation>
    </message>
    <message>
        <source>There is no such dip; the number of dips is %1, and the first is immersions[0]</source>
        <translation>Essa imersão não existe; o número de imersões é %1, e a primeira é immersions[0]</translation>
    </message>
    <message>
        <source>inspection.pairs names a photo that is not in inspection.photos</source>
        <translation>inspection.pairs nomeia uma foto que não está em inspection.photos</translation>
    </message>
    <message>
        <source>%1 × %2 points are too many; a film may have up to %3 million points</source>
        <translation>%1 × %2 pontos são demais; uma película pode ter até %3 milhões de pontos</translation>
    </message>
    <message>
        <source>A spot colour needs its own name; All, None and the names of the four process inks are reserved</source>
        <translation>Uma cor especial precisa de um nome próprio; All, None e os nomes das quatro tintas de processo são reservados</translation>
    </message>
    <message>
        <source>“%1” is not a colour; write it as #1a2b3c</source>
        <translation>“%1” não é uma cor; escreva como #1a2b3c</translation>
    </message>
    <message>
        <source>%1 is not allowed here; expected %2 values, each of them %3</source>
        <translation>%1 não é permitido aqui; esperados %2 valores, cada um %3</translation>
    </message>
    <message>
        <source>the settings in this section are %1</source>
        <translation>as configurações desta seção são %1</translation>
    </message>
    <message>
        <source>%1 is not allowed here; expected a list of at most %2 entries</source>
        <translation>%1 não é permitido aqui; espera-se uma lista de no máximo %2 entradas</translation>
    </message>
    <message>
        <source>In the poses of a path only the depth may be null; it then is the depth of the dip</source>
        <translation>Nas poses de um percurso só a profundidade pode ser null; ela é então a profundidade da imersão</translation>
    </message>
    <message>
        <source>In the poses of a path, times are at most %1 s, lengths %2 mm and turns %3°</source>
        <translation>Nas poses de um percurso, os tempos são de no máximo %1 s, os comprimentos de %2 mm e os giros de %3°</translation>
    </message>
    <message>
        <source>The brush strokes in %1 have %2 points; at most %3 are possible</source>
        <translation>As pinceladas em %1 têm %2 pontos; são possíveis no máximo %3</translation>
    </message>
    <message>
        <source>The value must be a list in JSON, as in the project file</source>
        <translation>O valor deve ser uma lista em JSON, como no arquivo do projeto</translation>
    </message>
    <message>
        <source>The normals of a brush stroke have parts from −1 to 1</source>
        <translation>As normais de uma pincelada têm componentes de −1 a 1</translation>
    </message>
    <message>
        <source>There is no such value; write its path as in the project file</source>
        <translation>Esse valor não existe; escreva o caminho dele como no arquivo do projeto</translation>
    </message>
    <message>
        <source>as_built.places names a part that is not in as_built.parts</source>
        <translation>as_built.places indica uma peça que não está em as_built.parts</translation>
    </message>
    <message>
        <source>A layer has no such setting; its settings are %1</source>
        <translation>Uma camada não tem essa configuração; suas configurações são %1</translation>
    </message>
    <message>
        <source>An empty value</source>
        <translation>Um valor vazio</translation>
    </message>
    <message>
        <source>%1 is not a date; write year, month and day, for example 2027-03-31</source>
        <translation>%1 não é uma data; escreva ano, mês e dia, por exemplo 2027-03-31</translation>
    </message>
    <message>
        <source>a path begins with one of %1</source>
        <translation>um caminho começa com uma destas palavras: %1</translation>
    </message>
    <message>
        <source>An entry has no such key; its keys are %1</source>
        <translation>Uma entrada não tem essa chave; as chaves são %1</translation>
    </message>
</context>
<context>
    <name>ProjectDifferences</name>
    <message>
        <source>Yes</source>
        <translation>Sim</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Não</translation>
    </message>
    <message>
        <source>Marks for zones</source>
        <translation>Marcas para zonas</translation>
    </message>
    <message>
        <source>Pose search · weight of %1</source>
        <translation>Busca de poses · peso de %1</translation>
    </message>
    <message>
        <source>Pose search · limit of %1</source>
        <translation>Busca de poses · limite de %1</translation>
    </message>
    <message>
        <source>Pose search · weight of zone %1</source>
        <translation>Busca de poses · peso da zona %1</translation>
    </message>
    <message>
        <source>Artwork · base colour</source>
        <translation>Arte · cor de base</translation>
    </message>
    <message>
        <source>Artwork · layer %1</source>
        <translation>Arte · camada %1</translation>
    </message>
    <message>
        <source>%1, %2 × %3%7 at (%4; %5; %6)%7, turned by %8°</source>
        <translation>%1, %2 × %3%7 em (%4; %5; %6)%7, girada em %8°</translation>
    </message>
    <message>
        <source>%1, with other settings</source>
        <translation>%1, com outras configurações</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Imersões</translation>
    </message>
    <message>
        <source>Marks for the seam</source>
        <translation>Marcas para a emenda</translation>
    </message>
    <message>
        <source>Printer profile</source>
        <translation>Perfil da impressora</translation>
    </message>
    <message>
        <source>Film profile</source>
        <translation>Perfil da película</translation>
    </message>
    <message>
        <source>Tank profile</source>
        <translation>Perfil do tanque</translation>
    </message>
    <message>
        <source>Marks for masks</source>
        <translation>Marcas para máscaras</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>%1 outras</translation>
    </message>
</context>
<context>
    <name>ProjectFile</name>
    <message>
        <source>The project is open elsewhere (%1); close it there, or work on a copy</source>
        <translation>O projeto está aberto em outro lugar (%1); feche-o lá ou trabalhe em uma cópia</translation>
    </message>
    <message>
        <source>The existing file cannot be read, so it is not replaced; try again, or save under another name</source>
        <translation>O arquivo existente não pode ser lido, por isso não é substituído; tente de novo ou salve com outro nome</translation>
    </message>
    <message>
        <source>Another program has changed the project since it was read, so it is not saved; open it again and repeat your change</source>
        <translation>Outro programa mudou o projeto desde que foi lido, por isso não é salvo; abra-o de novo e repita sua mudança</translation>
    </message>
</context>
<context>
    <name>ProjectStore</name>
    <message>
        <source>project.json is damaged at character %1: %2</source>
        <translation>project.json está danificado no caractere %1: %2</translation>
    </message>
    <message>
        <source>The project cannot be saved: %1</source>
        <translation>O projeto não pode ser salvo: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 em %2</translation>
    </message>
    <message>
        <source>The project was not saved, because its file would be refused when opened: %1</source>
        <translation>O projeto não foi salvo, porque o arquivo seria recusado ao ser aberto: %1</translation>
    </message>
    <message>
        <source>This is not a Dipwright project: it has no project.json</source>
        <translation>Isto não é um projeto do Dipwright: não tem project.json</translation>
    </message>
    <message>
        <source>project.json contains a list instead of a project</source>
        <translation>project.json contém uma lista em vez de um projeto</translation>
    </message>
    <message>
        <source>The project names no model: model.mesh is missing</source>
        <translation>O projeto não nomeia nenhum modelo: falta model.mesh</translation>
    </message>
    <message>
        <source>The model in the project was changed after saving: its sha256 differs</source>
        <translation>O modelo no projeto foi alterado depois de salvo: seu sha256 difere</translation>
    </message>
    <message>
        <source>The project lists %1 textures, but its model needs %2</source>
        <translation>O projeto lista %1 texturas, mas seu modelo precisa de %2</translation>
    </message>
    <message>
        <source>Saving the project</source>
        <translation>Salvando o projeto</translation>
    </message>
    <message>
        <source>project.json holds the key %1 twice; remove one of them</source>
        <translation>project.json contém a chave %1 duas vezes; remova uma delas</translation>
    </message>
</context>
<context>
    <name>ProjectValue</name>
    <message>
        <source>There is no such setting</source>
        <translation>Essa configuração não existe</translation>
    </message>
</context>
<context>
    <name>Proof</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Impresso</translation>
    </message>
    <message>
        <source>The part as it is expected to come out</source>
        <translation>A peça como se espera que fique</translation>
    </message>
    <message>
        <source>After dip 1</source>
        <translation>Após a imersão 1</translation>
    </message>
    <message>
        <source>The part after %1</source>
        <translation>A peça após %1</translation>
    </message>
    <message>
        <source>Artwork</source>
        <translation>Arte</translation>
    </message>
    <message>
        <source>The picture that was asked for</source>
        <translation>A imagem pedida</translation>
    </message>
    <message>
        <source>bare</source>
        <translation>nua</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mais</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramento</translation>
    </message>
    <message>
        <source>How many times longer the film becomes on the part</source>
        <translation>Quantas vezes mais longa a película fica na peça</translation>
    </message>
    <message>
        <source>Numerical error</source>
        <translation>Erro numérico</translation>
    </message>
    <message>
        <source>How far the picture may be off by computing, in mm. Limit: %1 mm</source>
        <translation>Quanto a imagem pode errar por causa do cálculo, em mm. Limite: %1 mm</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerância</translation>
    </message>
    <message>
        <source>How far handling may move the picture, ± mm</source>
        <translation>Quanto o manuseio pode deslocar a imagem, ± mm</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Peça</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Imersões</translation>
    </message>
    <message>
        <source>Painted by all dips together</source>
        <translation>Pintado por todas as imersões juntas</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Length of the seam</source>
        <translation>Comprimento da emenda</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Dip %1: %2</source>
        <translation>Imersão %1: %2</translation>
    </message>
    <message>
        <source>Painted</source>
        <translation>Pintado</translation>
    </message>
    <message>
        <source>Stretch: mean, 95 % below, largest</source>
        <translation>Estiramento: médio, 95 % abaixo, maior</translation>
    </message>
    <message>
        <source>Numerical error, 95 % within</source>
        <translation>Erro numérico, 95 % dentro de</translation>
    </message>
    <message>
        <source>Read-back error, 95 % within</source>
        <translation>Erro de releitura, 95 % dentro de</translation>
    </message>
    <message>
        <source>Tolerance of handling, 95 % within ±</source>
        <translation>Tolerância do manuseio, 95 % dentro de ±</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Ar preso</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabalho</translation>
    </message>
    <message>
        <source>%1 × %2 mm, job %3</source>
        <translation>%1 × %2 mm, trabalho %3</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Veredito: %1</translation>
    </message>
    <message>
        <source>The surface shown here is within %1 mm of the part.</source>
        <translation>A superfície mostrada aqui está a no máximo %1 mm da peça.</translation>
    </message>
    <message>
        <source>The surface shown here has all triangles of the part.</source>
        <translation>A superfície mostrada aqui tem todos os triângulos da peça.</translation>
    </message>
    <message>
        <source>Screens show colours differently; the print decides.</source>
        <translation>As telas mostram as cores de formas diferentes; vale a impressão.</translation>
    </message>
    <message>
        <source>Making the proof to share</source>
        <translation>Gerando a prova para compartilhar</translation>
    </message>
    <message>
        <source>This program was built without three.js, which shows the proof in a browser. Build it with the package libjs-three installed, or share proof.png</source>
        <translation>Este programa foi compilado sem three.js, que mostra a prova no navegador. Compile-o com o pacote libjs-three instalado, ou compartilhe proof.png</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Acima</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Abaixo</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Prova</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Trabalho %1</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Camada</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>The part. Arrow keys turn it, plus and minus zoom, 0 resets</source>
        <translation>A peça. As setas a giram, mais e menos dão zoom, 0 restaura</translation>
    </message>
    <message>
        <source>Drag to turn. Wheel or two fingers zoom and move. Arrow keys turn, + and − zoom.</source>
        <translation>Arraste para girar. A roda ou dois dedos dão zoom e movem. As setas giram, + e − dão zoom.</translation>
    </message>
    <message>
        <source>This browser cannot draw in 3D (WebGL). The picture shows the part from six sides.</source>
        <translation>Este navegador não desenha em 3D (WebGL). A imagem mostra a peça de seis lados.</translation>
    </message>
    <message>
        <source>The part from six sides</source>
        <translation>A peça de seis lados</translation>
    </message>
    <message>
        <source>Sheets, ink side up</source>
        <translation>Folhas, lado da tinta para cima</translation>
    </message>
    <message>
        <source>Made by %1. The viewer is three.js.</source>
        <translation>Feito com %1. O visualizador é three.js.</translation>
    </message>
    <message>
        <source>Licence of the viewer</source>
        <translation>Licença do visualizador</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>não comparado</translation>
    </message>
    <message>
        <source>Masked, not painted</source>
        <translation>Mascarado, não pintado</translation>
    </message>
</context>
<context>
    <name>PropertySpecs</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Distance field</source>
        <translation>Campo de distância</translation>
    </message>
    <message>
        <source>Samples per edge</source>
        <translation>Amostras por aresta</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolução</translation>
    </message>
    <message>
        <source>Printed film</source>
        <translation>Película impressa</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Behaviour on the water</source>
        <translation>Comportamento na água</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Inchamento</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxação</translation>
    </message>
    <message>
        <source>Film model</source>
        <translation>Modelo da película</translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation>Isotrópico</translation>
    </message>
    <message>
        <source>Structural lattice</source>
        <translation>Rede estrutural</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Apoio</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Água</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhum</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Lados</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimento</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidade</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Precisão</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Passo de tempo</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterações</translation>
    </message>
    <message>
        <source>Self-contact</source>
        <translation>Autocontato</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotação</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Deslocamento</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Paisagem</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>Sangria</translation>
    </message>
    <message>
        <source>Registration marks</source>
        <translation>Marcas de registro</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Régua</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>Linha de trabalho</translation>
    </message>
    <message>
        <source>Compensate stretch</source>
        <translation>Compensar estiramento</translation>
    </message>
    <message>
        <source>Ink limit</source>
        <translation>Limite de tinta</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automática</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Número de pontos</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Células</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Sobreposição</translation>
    </message>
    <message>
        <source>Registration error</source>
        <translation>Erro de registro</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Berço</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Folga</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Forro</translation>
    </message>
    <message>
        <source>Pin clearance</source>
        <translation>Folga dos pinos</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Furo</translation>
    </message>
    <message>
        <source>Engraving</source>
        <translation>Gravação</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Nível da água</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Imersões</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Correção</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidade</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Dipping</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Folha</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinta</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerâncias</translation>
    </message>
    <message>
        <source>Along the film&apos;s edge</source>
        <translation>Ao longo da borda da película</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distância</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Branco</translation>
    </message>
    <message>
        <source>Printed last, under the colour</source>
        <translation>Impresso por último, sob a cor</translation>
    </message>
    <message>
        <source>Printed first, over the colour</source>
        <translation>Impresso primeiro, sobre a cor</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidade</translation>
    </message>
    <message>
        <source>Choke</source>
        <translation>Recuo</translation>
    </message>
    <message>
        <source>Print it</source>
        <translation>Pode imprimir</translation>
    </message>
    <message>
        <source>Check first</source>
        <translation>Verificar primeiro</translation>
    </message>
    <message>
        <source>Do not print</source>
        <translation>Não imprima</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Ar preso</translation>
    </message>
    <message>
        <source>Too pale</source>
        <translation>Claro demais</translation>
    </message>
    <message>
        <source>Torn or released film</source>
        <translation>Película rasgada ou solta</translation>
    </message>
    <message>
        <source>Reached by neither dip</source>
        <translation>Não alcançado por nenhuma imersão</translation>
    </message>
    <message>
        <source>Narrow overlap</source>
        <translation>Sobreposição estreita</translation>
    </message>
    <message>
        <source>Repaired model</source>
        <translation>Modelo corrigido</translation>
    </message>
    <message>
        <source>Film not measured</source>
        <translation>Película não medida</translation>
    </message>
    <message>
        <source>Expected deviations (±)</source>
        <translation>Desvios esperados (±)</translation>
    </message>
    <message>
        <source>The name of the project. It is printed in the job line of every sheet.</source>
        <translation>O nome do projeto. É impresso na linha de trabalho de cada folha.</translation>
    </message>
    <message>
        <source>The date in the job line. It is stored in the project, so that the same project always gives the same sheet.</source>
        <translation>A data na linha de trabalho. Ela é salva no projeto, para que o mesmo projeto dê sempre a mesma folha.</translation>
    </message>
    <message>
        <source>Number of samples along each edge of the distance field around the part. More samples follow finer detail and take longer to compute.</source>
        <translation>Número de amostras em cada aresta do campo de distância em volta da peça. Mais amostras seguem detalhes mais finos e demoram mais.</translation>
    </message>
    <message>
        <source>The size of the film as it is delivered and printed.</source>
        <translation>O tamanho em que a película é fornecida e impressa.</translation>
    </message>
    <message>
        <source>How fine the simulated film is. “Automatic” chooses the cell size from the part&apos;s narrow features and its pose: fine where the part enters the film, coarse towards the film&apos;s edges.</source>
        <translation>Quão fina é a película simulada. “Automática” escolhe o tamanho das células pelas partes estreitas da peça e pela sua pose: pequenas onde a peça entra na película, grandes em direção às bordas.</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Tamanho das células</translation>
    </message>
    <message>
        <source>Side length of the simulated film&apos;s cells where the part enters the film. Smaller cells show finer detail and take longer.</source>
        <translation>Lado das células da película simulada onde a peça entra na película. Células menores mostram detalhes mais finos e demoram mais.</translation>
    </message>
    <message>
        <source>Gap between the cradle and the part that lies in it.</source>
        <translation>Folga entre o berço e a peça que está nele.</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Espessura da parede</translation>
    </message>
    <message>
        <source>The smallest thickness of the walls that hold the part.</source>
        <translation>A menor espessura das paredes que seguram a peça.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>How far below the top of the part the cradle reaches. It reaches deeper where the part would tip or slide.</source>
        <translation>Quanto abaixo do topo da peça o berço alcança. Ele desce mais onde a peça tombaria ou escorregaria.</translation>
    </message>
    <message>
        <source>Distance to the film</source>
        <translation>Distância da película</translation>
    </message>
    <message>
        <source>Space for felt or foam where the cradle rests on paint.</source>
        <translation>Espaço para feltro ou espuma onde o berço se apoia em tinta.</translation>
    </message>
    <message>
        <source>Plate thickness</source>
        <translation>Espessura da placa</translation>
    </message>
    <message>
        <source>Thickness of the plate that the cradle hangs from.</source>
        <translation>Espessura da placa em que o berço está pendurado.</translation>
    </message>
    <message>
        <source>Height above the water</source>
        <translation>Altura acima da água</translation>
    </message>
    <message>
        <source>Height of the plate above the water at the end of the dip.</source>
        <translation>Altura da placa acima da água no fim da imersão.</translation>
    </message>
    <message>
        <source>Pin spacing</source>
        <translation>Distância entre pinos</translation>
    </message>
    <message>
        <source>Largest distance between two datum pins. The pins stand where the sheet&apos;s marks float, or closer to the film&apos;s centre.</source>
        <translation>Maior distância entre dois pinos de referência. Os pinos ficam onde as marcas da folha flutuam, ou mais perto do centro da película.</translation>
    </message>
    <message>
        <source>Pin diameter</source>
        <translation>Diâmetro dos pinos</translation>
    </message>
    <message>
        <source>Diameter of the datum pins on the tank&apos;s frame.</source>
        <translation>Diâmetro dos pinos de referência da armação do tanque.</translation>
    </message>
    <message>
        <source>Gap between a pin and its hole, all round.</source>
        <translation>Folga entre o pino e o furo, em toda a volta.</translation>
    </message>
    <message>
        <source>Diameter of a hole through the cradle and its plate, for holding the part with a screw, suction or hot glue. 0: no hole.</source>
        <translation>Diâmetro de um furo através do berço e da sua placa, para segurar a peça com parafuso, sucção ou cola quente. 0: sem furo.</translation>
    </message>
    <message>
        <source>Depth of the engraved arrow, dip number and job number in the plate. 0: no engraving.</source>
        <translation>Profundidade da gravação da seta, do número da imersão e do número do trabalho na placa. 0: sem gravação.</translation>
    </message>
    <message>
        <source>Side length of the cells on which the cradle is computed. Smaller cells give a smoother surface, take longer and make larger files.</source>
        <translation>Lado das células em que o berço é calculado. Células menores dão uma superfície mais lisa, demoram mais e geram arquivos maiores.</translation>
    </message>
    <message>
        <source>How far the lowest point of the part goes below the waterline. “Whole part” dips until the part is fully under water.</source>
        <translation>Quanto o ponto mais baixo da peça desce abaixo da linha d&apos;água. “Peça inteira” mergulha até a peça ficar toda submersa.</translation>
    </message>
    <message>
        <source>Whole part</source>
        <translation>Peça inteira</translation>
    </message>
    <message>
        <source>How much farther the part moves down once it is fully under water.</source>
        <translation>Quanto mais a peça desce depois de totalmente submersa.</translation>
    </message>
    <message>
        <source>The simulated time of one step.</source>
        <translation>O tempo simulado de um passo.</translation>
    </message>
    <message>
        <source>Number of sweeps over all constraints in one step.</source>
        <translation>Número de passagens por todas as restrições em um passo.</translation>
    </message>
    <message>
        <source>Sweep method</source>
        <translation>Método de passagem</translation>
    </message>
    <message>
        <source>Jacobi corrects all points at once and averages the corrections. Gauss–Seidel corrects one point after the other.</source>
        <translation>Jacobi corrige todos os pontos de uma vez e tira a média das correções. Gauss–Seidel corrige um ponto após o outro.</translation>
    </message>
    <message>
        <source>The name of this dip. It is printed in the job line of its sheet.</source>
        <translation>O nome desta imersão. É impresso na linha de trabalho da folha.</translation>
    </message>
    <message>
        <source>Split the part between the dips</source>
        <translation>Dividir a peça entre as imersões</translation>
    </message>
    <message>
        <source>Each dip paints the areas where it gives the better result and leaves the others blank. If off, both dips paint everything they reach, and some areas are painted twice.</source>
        <translation>Cada imersão pinta as áreas em que dá o melhor resultado e deixa as outras em branco. Se desligado, ambas pintam tudo o que alcançam, e algumas áreas são pintadas duas vezes.</translation>
    </message>
    <message>
        <source>How far the second dip may be displaced from the first. The overlap is made wide enough that no edge shows.</source>
        <translation>Quanto a segunda imersão pode estar deslocada em relação à primeira. A sobreposição fica larga o bastante para que nenhuma borda apareça.</translation>
    </message>
    <message>
        <source>Stretch limit</source>
        <translation>Limite de estiramento</translation>
    </message>
    <message>
        <source>Where the film of one dip stretches beyond this factor, the other dip paints if it can.</source>
        <translation>Onde a película de uma imersão estica além deste fator, a outra imersão pinta, se puder.</translation>
    </message>
    <message>
        <source>Turns the page on its side.</source>
        <translation>Vira a página de lado.</translation>
    </message>
    <message>
        <source>Pixels per inch of the film image.</source>
        <translation>Pixels por polegada da imagem da película.</translation>
    </message>
    <message>
        <source>How far the colour continues beyond the painted area, so that a small position error leaves no bare edge.</source>
        <translation>Quanto a cor continua além da área pintada, para que um pequeno erro de posição não deixe borda nua.</translation>
    </message>
    <message>
        <source>Marks in the corners, for aligning the film in the tank.</source>
        <translation>Marcas nos cantos para alinhar a película no tanque.</translation>
    </message>
    <message>
        <source>A ruler of 100 mm. Measure it to check that the page was printed at true size.</source>
        <translation>Uma régua de 100 mm. Meça-a para verificar se a página saiu em tamanho real.</translation>
    </message>
    <message>
        <source>A line with project, dip, date, film, scale and a checksum.</source>
        <translation>Uma linha com projeto, imersão, data, película, escala e soma de verificação.</translation>
    </message>
    <message>
        <source>Part colour</source>
        <translation>Cor da peça</translation>
    </message>
    <message>
        <source>How far the edge of the white stays inside the edge of the colour, on the film.</source>
        <translation>Quanto a borda do branco fica para dentro da borda da cor, na película.</translation>
    </message>
    <message>
        <source>Name of the white ink</source>
        <translation>Nome da tinta branca</translation>
    </message>
    <message>
        <source>The name of the white ink in the printer.</source>
        <translation>O nome da tinta branca na impressora.</translation>
    </message>
    <message>
        <source>Cut contour</source>
        <translation>Contorno de corte</translation>
    </message>
    <message>
        <source>Around the ink</source>
        <translation>Em volta da tinta</translation>
    </message>
    <message>
        <source>Distance from the ink to the cut contour.</source>
        <translation>Distância entre a tinta e o contorno de corte.</translation>
    </message>
    <message>
        <source>Bleed at the contour</source>
        <translation>Sangria no contorno</translation>
    </message>
    <message>
        <source>How far the colours continue beyond the cut contour, so that a misplaced cut shows no bare film.</source>
        <translation>Quanto as cores continuam além do contorno de corte, para que um corte desviado não mostre película nua.</translation>
    </message>
    <message>
        <source>Contour name</source>
        <translation>Nome do contorno</translation>
    </message>
    <message>
        <source>The name of the spot colour that the cutter follows.</source>
        <translation>O nome da cor especial que a cortadora segue.</translation>
    </message>
    <message>
        <source>Correct repeating errors</source>
        <translation>Corrigir erros repetidos</translation>
    </message>
    <message>
        <source>How much of the repeating error is corrected.</source>
        <translation>Quanto do erro repetido é corrigido.</translation>
    </message>
    <message>
        <source>Spot colours</source>
        <translation>Cores especiais</translation>
    </message>
    <message>
        <source>Ink thins where the film stretches. This prints more ink there, so that the part shows the colour of the texture.</source>
        <translation>A tinta afina onde a película estica. Isto imprime mais tinta ali, para que a peça mostre a cor da textura.</translation>
    </message>
    <message>
        <source>The highest optical density that can be printed. Where more is needed, the colour is too pale; the report gives the area.</source>
        <translation>A maior densidade óptica que pode ser impressa. Onde é preciso mais, a cor fica clara demais; o relatório dá a área.</translation>
    </message>
    <message>
        <source>Part position</source>
        <translation>Posição da peça</translation>
    </message>
    <message>
        <source>Part rotation</source>
        <translation>Rotação da peça</translation>
    </message>
    <message>
        <source>How far the part may be rotated from its pose, about axes through its centre.</source>
        <translation>Quanto a peça pode estar girada em relação à sua pose, em torno de eixos pelo seu centro.</translation>
    </message>
    <message>
        <source>Film position</source>
        <translation>Posição da película</translation>
    </message>
    <message>
        <source>How far the film may be from its intended place when the part meets it.</source>
        <translation>Quanto a película pode estar fora do lugar previsto quando a peça a toca.</translation>
    </message>
    <message>
        <source>Film rotation</source>
        <translation>Rotação da película</translation>
    </message>
    <message>
        <source>How far the film may be rotated on the water, about its centre.</source>
        <translation>Quanto a película pode estar girada na água, em torno do seu centro.</translation>
    </message>
    <message>
        <source>How much longer or shorter than assumed the floating film may be, as a share of its length.</source>
        <translation>Quanto a película flutuante pode ser mais longa ou mais curta que o suposto, como parte do seu comprimento.</translation>
    </message>
    <message>
        <source>The share of the part&apos;s surface that trapped air may keep dry. Above five times any of these limits, the verdict is “do not print”.</source>
        <translation>A parte da superfície da peça que o ar preso pode manter seca. Acima de cinco vezes qualquer destes limites o veredito é “Não imprima”.</translation>
    </message>
    <message>
        <source>The share of the painted area that may be too pale because the film stretches more than the ink can compensate.</source>
        <translation>A parte da área pintada que pode ficar clara demais porque a película estica mais do que a tinta consegue compensar.</translation>
    </message>
    <message>
        <source>The share of the painted area where the film may tear or be released from the part.</source>
        <translation>A parte da área pintada em que a película pode rasgar ou soltar-se da peça.</translation>
    </message>
    <message>
        <source>The share of the part&apos;s surface that both dips may leave unreached. A job with one dip has no such limit.</source>
        <translation>A parte da superfície da peça que as duas imersões podem deixar de alcançar. Um trabalho de uma só imersão não tem esse limite.</translation>
    </message>
    <message>
        <source>The share of the overlap that may be too narrow for the registration error of the second film.</source>
        <translation>A parte da sobreposição que pode ser estreita demais para o erro de registro da segunda película.</translation>
    </message>
    <message>
        <source>The share of a marked zone A or B that may stay unpainted.</source>
        <translation>A parte de uma zona A ou B marcada que pode ficar sem tinta.</translation>
    </message>
    <message>
        <source>The verdict for a model of one plain colour without artwork.</source>
        <translation>O veredito para um modelo de uma só cor sem arte.</translation>
    </message>
    <message>
        <source>The verdict for a film whose swell was not measured.</source>
        <translation>O veredito para uma película cujo inchamento não foi medido.</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Zonas</translation>
    </message>
    <message>
        <source>How far (±) colours may land from their intended places. Surface that is not marked is zone C.</source>
        <translation>Quanto (±) as cores podem cair fora do lugar previsto. Superfície não marcada é zona C.</translation>
    </message>
    <message>
        <source>Number of simulated dips with all deviations at once. They check whether the separate effects add up. 0: no check.</source>
        <translation>Número de imersões simuladas com todos os desvios juntos. Elas verificam se os efeitos separados se somam. 0: sem verificação.</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Emenda</translation>
    </message>
    <message>
        <source>Width (W) and height (H) of the printed film. The cells of the simulated film keep their size.</source>
        <translation>Largura (L) e altura (A) da película impressa. As células da película simulada mantêm o seu tamanho.</translation>
    </message>
    <message>
        <source>Number of points of the simulated film, across (W) and down (H). More points show finer detail and take longer.</source>
        <translation>Número de pontos da película simulada, na largura (L) e na altura (A). Mais pontos mostram detalhes mais finos e demoram mais.</translation>
    </message>
    <message>
        <source>Advanced: material laws that are not measured</source>
        <translation>Avançado: leis do material não medidas</translation>
    </message>
    <message>
        <source>Width (W) and height (H) of the page.</source>
        <translation>Largura (L) e altura (A) da página.</translation>
    </message>
    <message>
        <source>How far the part may be from its intended place when it meets the film. 95 of 100 dips are within this distance.</source>
        <translation>Quanto a peça pode estar longe do lugar previsto quando encontra a película. 95 de 100 imersões ficam dentro desta distância.</translation>
    </message>
    <message>
        <source>How much faster or slower the dip may be, as a share of the set speed.</source>
        <translation>Quanto a imersão pode ser mais rápida ou mais lenta, como parte da velocidade ajustada.</translation>
    </message>
    <message>
        <source>How much longer or shorter the film&apos;s relaxation time may be, as a share of the relaxation time.</source>
        <translation>Quanto o tempo de relaxação da película pode ser maior ou menor, como parte do tempo de relaxação.</translation>
    </message>
    <message>
        <source>The smallest allowed distance between film that paints and the film&apos;s edge. Nearer to the edge, film may curl or fold.</source>
        <translation>A menor distância permitida entre a película que pinta e a borda da película. Mais perto da borda ela pode enrolar ou dobrar.</translation>
    </message>
    <message>
        <source>Check with simulated dips</source>
        <translation>Verificação com imersões simuladas</translation>
    </message>
    <message>
        <source>Width, on the part, of the band along the seam that both dips paint. The dips fade into each other there. The band is wider where the registration error would show.</source>
        <translation>Largura, medida na peça, da faixa ao longo da emenda que as duas imersões pintam. As imersões se fundem uma na outra ali. A faixa é mais larga onde o erro de registro apareceria.</translation>
    </message>
    <message>
        <source>Contact with paint</source>
        <translation>Contato com a tinta</translation>
    </message>
    <message>
        <source>Whether the cradle may support the part on areas that earlier dips have painted, with padding in between.</source>
        <translation>Se o berço pode apoiar a peça em áreas que imersões anteriores pintaram, com acolchoamento no meio.</translation>
    </message>
    <message>
        <source>Work limit</source>
        <translation>Limite de trabalho</translation>
    </message>
    <message>
        <source>Isotropic film resists shear; the result does not depend on the direction of the grid. The structural lattice connects each point only with its horizontal and vertical neighbours, as in the publication of 2020.</source>
        <translation>A película isotrópica resiste ao cisalhamento; o resultado não depende da direção da grade. A rede estrutural liga cada ponto só aos seus vizinhos horizontais e verticais, como no artigo de 2020.</translation>
    </message>
    <message>
        <source>Water: the water supports the floating film. None: nothing supports the film.</source>
        <translation>Água: a água sustenta a película flutuante. Nenhum: nada sustenta a película.</translation>
    </message>
    <message>
        <source>Smallest distance from the cradle to any place that the film reaches or that earlier dips have painted.</source>
        <translation>Menor distância do berço a qualquer lugar que a película alcança ou que imersões anteriores pintaram.</translation>
    </message>
    <message>
        <source>Extra depth</source>
        <translation>Profundidade extra</translation>
    </message>
    <message>
        <source>Prevents the film from passing through itself.</source>
        <translation>Impede que a película atravesse a si mesma.</translation>
    </message>
    <message>
        <source>The page that the film image is placed on. “Same as the film” prints the film itself, edge to edge.</source>
        <translation>A página em que a imagem da película é posta. “Igual à película” imprime a própria película, de borda a borda.</translation>
    </message>
    <message>
        <source>Same as the film</source>
        <translation>Igual à película</translation>
    </message>
    <message>
        <source>Marks and text</source>
        <translation>Marcas e texto</translation>
    </message>
    <message>
        <source>Colour of the bare part, such as #1a2b3c. Proof and view show the ink on this colour. If empty, they show a light grey part, with the ink in the colours that it has on white.</source>
        <translation>Cor da peça nua, por exemplo #1a2b3c. A prova e a vista mostram a tinta sobre esta cor. Se vazio, mostram uma peça cinza-clara, com a tinta nas cores que ela tem sobre branco.</translation>
    </message>
    <message>
        <source>A plate of white ink. White that is printed last touches the part, under the colours. White that is printed first lies outside, over the colours. Only in CMYK files (PDF and TIFF).</source>
        <translation>Uma chapa de tinta branca. O branco impresso por último toca a peça, sob as cores. O branco impresso primeiro fica por fora, sobre as cores. Só em arquivos CMYK (PDF e TIFF).</translation>
    </message>
    <message>
        <source>How dense the white is on the finished part; 100 % is solid white. Where the film stretches, more white is printed, up to 100 %.</source>
        <translation>Quão denso é o branco na peça pronta; 100 % é branco cheio. Onde a película estica, imprime-se mais branco, até 100 %.</translation>
    </message>
    <message>
        <source>The line that the cutter follows, as a spot colour in a CMYK PDF.</source>
        <translation>A linha que a cortadora segue, como cor especial em um PDF em CMYK.</translation>
    </message>
    <message>
        <source>Shifts the image on the sheet so that it cancels the error that repeats on the measured parts.</source>
        <translation>Desloca a imagem na folha para anular o erro que se repete nas peças medidas.</translation>
    </message>
    <message>
        <source>How much higher or lower than intended the water may stand. The part is then dipped deeper or less deep.</source>
        <translation>Quanto mais alta ou mais baixa que o previsto a água pode estar. A peça então é mergulhada mais ou menos fundo.</translation>
    </message>
    <message>
        <source>Limits beyond which the verdict is “check first”</source>
        <translation>Limites além dos quais o veredito é “verificar primeiro”</translation>
    </message>
    <message>
        <source>Unpainted in a zone</source>
        <translation>Sem tinta numa zona</translation>
    </message>
    <message>
        <source>Distance to film&apos;s edge</source>
        <translation>Distância até a borda da película</translation>
    </message>
    <message>
        <source>No texture or artwork</source>
        <translation>Sem textura nem arte</translation>
    </message>
    <message>
        <source>Start value of the random deviations in the simulated dips. Another value gives other deviations.</source>
        <translation>Valor inicial dos desvios aleatórios nas imersões simuladas. Outro valor dá outros desvios.</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Straight down</source>
        <translation>Reto para baixo</translation>
    </message>
    <message>
        <source>Slanted</source>
        <translation>Inclinado</translation>
    </message>
    <message>
        <source>Tilt in and level</source>
        <translation>Tombar e nivelar</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rolar</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ângulo</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Direção</translation>
    </message>
    <message>
        <source>Level at</source>
        <translation>Nivelada em</translation>
    </message>
    <message>
        <source>The end of the dip</source>
        <translation>Fim da imersão</translation>
    </message>
    <message>
        <source>Rolling radius</source>
        <translation>Raio de rolamento</translation>
    </message>
    <message>
        <source>How far the part travels sideways while it rolls through one radian (57.3°). Half the part&apos;s height lets a cylinder roll without slip.</source>
        <translation>Quanto a peça avança de lado enquanto rola um radiano (57,3°). Com metade da altura da peça, um cilindro rola sem deslizar.</translation>
    </message>
    <message>
        <source>Half the part&apos;s height</source>
        <translation>Metade da altura da peça</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Turn about the vertical while the part goes down, counterclockwise seen from above.</source>
        <translation>Giro em torno da vertical enquanto a peça desce, no sentido anti-horário visto de cima.</translation>
    </message>
    <message>
        <source>Water speed</source>
        <translation>Velocidade da água</translation>
    </message>
    <message>
        <source>Slow speed</source>
        <translation>Velocidade lenta</translation>
    </message>
    <message>
        <source>The direction on the water in which the part travels or rolls, or the side that enters first. 0°: to the right (X), 90°: down the sheet (Z). The water flows in this direction, too.</source>
        <translation>A direção na água em que a peça avança ou rola, ou o lado que entra primeiro. 0°: para a direita (X), 90°: para a borda inferior da folha (Z). A água também corre nessa direção.</translation>
    </message>
    <message>
        <source>Slow distance</source>
        <translation>Distância lenta</translation>
    </message>
    <message>
        <source>The slow speed applies to the first and the last part of the way down. This is the length of each part.</source>
        <translation>A velocidade lenta vale no primeiro e no último trecho da descida. Este é o comprimento de cada trecho.</translation>
    </message>
    <message>
        <source>Film expired</source>
        <translation>Película vencida</translation>
    </message>
    <message>
        <source>The verdict for a film whose profile gives an expiry date in the past.</source>
        <translation>O veredito para uma película cujo perfil indica uma data de validade já passada.</translation>
    </message>
    <message>
        <source>Gauss–Seidel</source>
        <translation>Gauss–Seidel</translation>
    </message>
    <message>
        <source>Same as the dip</source>
        <translation>Igual à da imersão</translation>
    </message>
    <message>
        <source>Rotation of the part about X, then Y, then Z. If the part tilts, rolls or turns on its path: its rotation at the end of the dip. You can also drag the rings in the view; hold Shift for steps of 15°.</source>
        <translation>Rotação da peça em X, depois Y, depois Z. Se a peça tomba, rola ou gira no percurso: sua rotação no fim da imersão. Também é possível arrastar os anéis na vista; segure Shift para passos de 15°.</translation>
    </message>
    <message>
        <source>How fast the part moves down into the water. On a slanted path the machine moves faster, because the part also travels sideways.</source>
        <translation>Com que velocidade a peça desce na água. Em um percurso inclinado a máquina se move mais depressa, porque a peça também vai para o lado.</translation>
    </message>
    <message>
        <source>Slanted: the angle between the path and the water, 10° to 170°. Tilt: how far the part is tilted when the dip begins, at most 85°. Roll: the angle through which it rolls. Slanted above 90°, or a negative tilt or roll, is against the heading.</source>
        <translation>Inclinado: o ângulo entre o percurso e a água, de 10° a 170°. Tombar: quanto a peça está tombada quando a imersão começa, no máximo 85°. Rolar: o ângulo em que ela rola. Inclinado acima de 90°, ou um tombamento ou rolamento negativo, vai contra a direção.</translation>
    </message>
    <message>
        <source>Speed at which water and film flow through the tank, in the direction of the heading. A negative speed flows against the heading.</source>
        <translation>Velocidade com que a água e a película correm pelo tanque, no sentido da direção. Uma velocidade negativa corre contra a direção.</translation>
    </message>
    <message>
        <source>Speed on the first and the last part of the way down. If the part then rolls, it rolls at the speed of the dip.</source>
        <translation>Velocidade na primeira e na última parte da descida. Se a peça depois rola, ela rola na velocidade da imersão.</translation>
    </message>
    <message>
        <source>Where the centre of the part is when the dip begins, measured from the film&apos;s centre: X to the right, Z down the sheet.</source>
        <translation>Onde está o centro da peça quando a imersão começa, medido do centro da película: X para a direita, Z para baixo na folha.</translation>
    </message>
    <message>
        <source>Depth of the part&apos;s lowest point at which the part is no longer tilted.</source>
        <translation>Profundidade do ponto mais baixo em que a peça já não está tombada.</translation>
    </message>
    <message>
        <source>Path angle</source>
        <translation>Ângulo do percurso</translation>
    </message>
    <message>
        <source>How far the angle of a slanted, tilted or rolling dip may be from its set value. Has no effect on other dips.</source>
        <translation>Quanto o ângulo de uma imersão inclinada, tombada ou rolada pode desviar do valor ajustado. Não tem efeito em outras imersões.</translation>
    </message>
    <message>
        <source>Start of the dip</source>
        <translation>Início da imersão</translation>
    </message>
    <message>
        <source>How much earlier or later than intended the dip may begin. Has an effect only if the water flows or the film grows.</source>
        <translation>Quanto antes ou depois do previsto a imersão pode começar. Só tem efeito se a água corre ou a película cresce.</translation>
    </message>
    <message>
        <source>How the part moves into the water. Slanted: down and sideways. Tilt: one side enters first, and the part is levelled while it goes down. Roll: down to the depth of the dip, then rolled sideways over the film; set a depth (Dipping &gt; Depth) at which the part is not yet under water. Poses: through poses that you set; at first they follow the present path. The rotation above is the part&apos;s rotation at the end of the dip.</source>
        <translation>Como a peça se move para dentro da água. Inclinado: para baixo e de lado. Tombar: um lado entra primeiro e a peça é nivelada enquanto desce. Rolar: para baixo até a profundidade da imersão e depois rolada de lado sobre a película; defina uma profundidade (Imersão &gt; Profundidade) em que a peça ainda não esteja debaixo da água. Poses: por poses que você define; no início elas seguem o percurso atual. A rotação acima é a rotação da peça no fim da imersão.</translation>
    </message>
    <message>
        <source>Through poses</source>
        <translation>Por poses</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleração</translation>
    </message>
    <message>
        <source>The acceleration with which the part reaches its speed on the path and stops. The dip takes longer than without a limit.</source>
        <translation>A aceleração com que a peça chega à sua velocidade no percurso e para. A imersão dura mais que sem limite.</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sem limite</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Pedido</translation>
    </message>
    <message>
        <source>Parts to make</source>
        <translation>Peças a fazer</translation>
    </message>
    <message>
        <source>The number of good parts that are ordered. Report, queue and traveller give the cost and the time of the order. Sheets do not depend on it.</source>
        <translation>Número de peças boas que foram pedidas. O relatório, a fila e a ficha de acompanhamento dão o custo e o tempo do pedido. As folhas não dependem dele.</translation>
    </message>
    <message>
        <source>If the numerical error is too large to print a sheet, its dip is repeated with smaller cells. This limits the work of one dip: the number of film points times the number of steps, in millions. 100 takes about 20 s on two cores. 0: the dip is not repeated.</source>
        <translation>Se o erro numérico for grande demais para imprimir uma folha, a imersão é repetida com células menores. Este valor limita o trabalho de uma imersão: o número de pontos da película vezes o número de passos, em milhões. 100 levam cerca de 20 s em dois núcleos. 0: a imersão não é repetida.</translation>
    </message>
    <message>
        <source>Densest colour</source>
        <translation>Cor mais densa</translation>
    </message>
    <message>
        <source>Passes of ink</source>
        <translation>Passadas de tinta</translation>
    </message>
    <message>
        <source>How many times the printer prints each sheet onto the same film. Two passes reach twice the ink limit. The film must not move between the passes, and takes longer to dry. Usual: 1.</source>
        <translation>Quantas vezes a impressora imprime cada folha na mesma película. Duas passadas alcançam o dobro do limite de tinta. A película não pode se mover entre as passadas e leva mais tempo para secar. Usual: 1.</translation>
    </message>
    <message>
        <source>A tone curve lightens the darkest colours of the texture to this density and keeps them apart, so that the ink suffices on stretched film. Usual: 0.8 to 1.8. At 10 the texture stays as it is. The amounts of ink of CMYK pictures do not change.</source>
        <translation>Uma curva tonal clareia as cores mais escuras da textura até esta densidade e as mantém distintas, para que a tinta baste na película esticada. Usual: 0,8 a 1,8. Em 10 a textura fica como está. As quantidades de tinta de imagens CMYK não mudam.</translation>
    </message>
    <message>
        <source>Wanted error</source>
        <translation>Erro desejado</translation>
    </message>
    <message>
        <source>The dip is repeated with smaller cells until the numerical error is at most this on 95 % of the painted area, or until the work limit is reached. “Printable”: only until the sheet can be printed.</source>
        <translation>A imersão é repetida com células menores até que o erro numérico seja no máximo este em 95 % da área pintada, ou até o limite de trabalho. “Imprimível”: só até que a folha possa ser impressa.</translation>
    </message>
    <message>
        <source>Printable</source>
        <translation>Imprimível</translation>
    </message>
    <message>
        <source>How far the contact line moves in one step, in cells of the film. For a more exact sheet, smaller cells are better than steps below 0.5.</source>
        <translation>Quanto a linha de contato avança em um passo, em células da película. Para uma folha mais exata, células menores são melhores do que passos abaixo de 0,5.</translation>
    </message>
    <message>
        <source>Least painted area</source>
        <translation>Menor área pintada</translation>
    </message>
    <message>
        <source>The share of the part&apos;s surface that the only dip of a job should paint.</source>
        <translation>A parte da superfície da peça que a única imersão de um trabalho deve pintar.</translation>
    </message>
    <message>
        <source>The verdict for a model that was repaired.</source>
        <translation>O veredito para um modelo que foi corrigido.</translation>
    </message>
    <message>
        <source>Incomplete model</source>
        <translation>Modelo incompleto</translation>
    </message>
    <message>
        <source>The verdict for a model of which the import left something out, such as a missing texture or a texture transform.</source>
        <translation>O veredito para um modelo do qual a importação deixou algo de fora, como uma textura ausente ou uma transformação de textura.</translation>
    </message>
</context>
<context>
    <name>ReportPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Area stretch, smallest and largest</source>
        <translation>Estiramento de área, menor e maior</translation>
    </message>
    <message>
        <source>Film triangles across texture seams</source>
        <translation>Triângulos da película sobre costuras da textura</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Passos</translation>
    </message>
    <message>
        <source>Width of the overlap</source>
        <translation>Largura da sobreposição</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>Painted by %1 only</source>
        <translation>Pintado só por %1</translation>
    </message>
    <message>
        <source>Overlap, painted by both</source>
        <translation>Sobreposição, pintada por ambas</translation>
    </message>
    <message>
        <source>Reached by neither dip</source>
        <translation>Não alcançado por nenhuma imersão</translation>
    </message>
    <message>
        <source>Overlap too narrow for a registration error of %1</source>
        <translation>Sobreposição estreita demais para um erro de registro de %1</translation>
    </message>
    <message>
        <source>Length of the seam</source>
        <translation>Comprimento da emenda</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Emenda</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>Film points on the part</source>
        <translation>Pontos da película na peça</translation>
    </message>
    <message>
        <source>Read-back error, mean and 95 %</source>
        <translation>Erro de releitura, médio e 95 %</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Ar preso</translation>
    </message>
    <message>
        <source>Steps that did not converge</source>
        <translation>Passos que não convergiram</translation>
    </message>
    <message>
        <source>Use this film</source>
        <translation>Usar esta película</translation>
    </message>
    <message>
        <source>Area not reached, at %1</source>
        <translation>Área não alcançada, em %1</translation>
    </message>
    <message>
        <source>Number of smaller areas not reached</source>
        <translation>Número de áreas menores não alcançadas</translation>
    </message>
    <message>
        <source>Area painted by film that tore, was released or did not converge</source>
        <translation>Área pintada por película que rasgou, se soltou ou não convergiu</translation>
    </message>
    <message>
        <source>Area too pale because of the ink limit</source>
        <translation>Área clara demais por causa do limite de tinta</translation>
    </message>
    <message>
        <source>Simulation time</source>
        <translation>Duração da simulação</translation>
    </message>
    <message>
        <source>Most of the film stays empty. A film of format %1 (%2 × %3) is large enough.</source>
        <translation>A maior parte da película fica vazia. Uma película no formato %1 (%2 × %3) é grande o bastante.</translation>
    </message>
    <message>
        <source>Smallest film cell</source>
        <translation>Menor célula da película</translation>
    </message>
    <message>
        <source>%1 on the model</source>
        <translation>%1 no modelo</translation>
    </message>
    <message>
        <source>Stretch: mean, 99 % below, largest</source>
        <translation>Estiramento: médio, 99 % abaixo, maior</translation>
    </message>
    <message>
        <source>Place of the largest stretch</source>
        <translation>Lugar do maior estiramento</translation>
    </message>
    <message>
        <source>Warnings on the part</source>
        <translation>Avisos na peça</translation>
    </message>
    <message>
        <source>Cost and time</source>
        <translation>Custo e tempo</translation>
    </message>
    <message>
        <source>One part</source>
        <translation>Uma peça</translation>
    </message>
    <message>
        <source>Order of %1 parts</source>
        <translation>Pedido de %1 peças</translation>
    </message>
    <message>
        <source>Sheets to print</source>
        <translation>Folhas a imprimir</translation>
    </message>
    <message>
        <source>The amounts of ink are estimated, because the project has no printer profile with an ICC profile in CMYK.</source>
        <translation>As quantidades de tinta são estimadas, porque o projeto não tem um perfil de impressora com um perfil ICC em CMYK.</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Salvar como CSV…</translation>
    </message>
    <message>
        <source>Edit prices…</source>
        <translation>Editar preços…</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Planejado</translation>
    </message>
    <message>
        <source>Took, mean of all runs</source>
        <translation>Levou, média de todas as vezes</translation>
    </message>
    <message>
        <source>Dip %1: %2</source>
        <translation>Imersão %1: %2</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 a %3)</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>No tanque</translation>
    </message>
    <message>
        <source>Too pale: needs more ink than the limit</source>
        <translation>Pálido demais: precisa de mais tinta do que o limite</translation>
    </message>
    <message>
        <source>Too pale</source>
        <translation>Clara demais</translation>
    </message>
    <message>
        <source>Missing, 95 %</source>
        <translation>Falta, 95 %</translation>
    </message>
    <message>
        <source>Missing, most</source>
        <translation>Falta, maior</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Contraste</translation>
    </message>
    <message>
        <source>Colour error ΔE</source>
        <translation>Erro de cor ΔE</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Agora</translation>
    </message>
    <message>
        <source>Where ink does not suffice</source>
        <translation>Onde a tinta não basta</translation>
    </message>
    <message>
        <source>A click on an option changes the project; it can be undone. Too pale: share of the painted surface. Missing: optical density where ink is short now (95 %), and the most anywhere. Contrast: of the texture, where ink is short now. Colour error: mean difference to the texture on the painted surface.</source>
        <translation>Um clique numa opção muda o projeto; dá para desfazer. Clara demais: parte da superfície pintada. Falta: densidade óptica onde a tinta não basta agora (95 %) e a maior em qualquer lugar. Contraste: da textura, onde a tinta não basta agora. Erro de cor: diferença média para a textura na superfície pintada.</translation>
    </message>
</context>
<context>
    <name>RunCommand</name>
    <message>
        <source>Project %1 of %2: %3</source>
        <translation>Projeto %1 de %2: %3</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 gravado</translation>
    </message>
    <message>
        <source>Coverage by all dips: %1 %</source>
        <translation>Cobertura por todas as imersões: %1 %</translation>
    </message>
    <message>
        <source>%1 % of the film is used; the smaller size %2 (%3 × %4 mm) is large enough</source>
        <translation>%1 % da película são usados; o formato menor %2 (%3 × %4 mm) é grande o bastante</translation>
    </message>
    <message>
        <source>Film: swell guessed</source>
        <translation>Película: inchamento estimado</translation>
    </message>
    <message>
        <source>Film: swell measured on %1</source>
        <translation>Película: inchamento medido em %1</translation>
    </message>
    <message>
        <source>Solver: %1 %2 on %3</source>
        <translation>Solucionador: %1 %2 em %3</translation>
    </message>
    <message>
        <source>%1: %2 × %3 points, cells of %4 mm over the part, %5, coverage %6 %, read-back error of the texture %7 mm (95 %)</source>
        <translation>%1: %2 × %3 pontos, células de %4 mm sobre a peça, %5, cobertura %6 %, erro de releitura da textura %7 mm (95 %)</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 passos</translation>
    </message>
    <message>
        <source>%1 steps in %2 s</source>
        <translation>%1 passos em %2 s</translation>
    </message>
    <message>
        <source>%1: the cradle is %2 mm from the part and %3 mm from the paint, supports %4 mm² of the part and may be tilted by %5°</source>
        <translation>%1: o berço fica a %2 mm da peça e a %3 mm da tinta, apoia %4 mm² da peça e pode ser tombado em %5°</translation>
    </message>
    <message>
        <source>Seam: %1 mm long</source>
        <translation>Emenda: %1 mm de comprimento</translation>
    </message>
    <message>
        <source>Seam: %1 mm long, %2 % as visible as a plain cut halfway between the poses</source>
        <translation>Emenda: %1 mm de comprimento, %2 % tão visível quanto um corte simples a meio caminho entre as poses</translation>
    </message>
    <message>
        <source>smaller places that only report.json lists: %1</source>
        <translation>lugares menores que só report.json lista: %1</translation>
    </message>
    <message>
        <source>not reached: %1 mm² at x %2 mm, y %3 mm, z %4 mm on the model</source>
        <translation>não alcançado: %1 mm² em x %2 mm, y %3 mm, z %4 mm no modelo</translation>
    </message>
    <message>
        <source>Split between the dips: %1 %2, %3 %4, overlap %5 with a width of %6 to %7 mm, not painted %8</source>
        <translation>Divisão entre as imersões: %1 %2, %3 %4, sobreposição %5 com largura de %6 a %7 mm, não pintado %8</translation>
    </message>
    <message>
        <source>%1 mm² (%2 %)</source>
        <translation>%1 mm² (%2 %)</translation>
    </message>
    <message>
        <source>±%1 mm at x %2 mm, y %3 mm, z %4 mm on the model, largest cause: %5</source>
        <translation>±%1 mm em x %2 mm, y %3 mm, z %4 mm no modelo, maior causa: %5</translation>
    </message>
    <message>
        <source>moves the border of the paint: %1 mm² less or %2 mm² more painted</source>
        <translation>desloca a borda da área pintada: %1 mm² a menos ou %2 mm² a mais pintados</translation>
    </message>
    <message>
        <source>%1 ±%2 %3: %4 % of the spread, %5</source>
        <translation>%1 ±%2 %3: %4 % da dispersão, %5</translation>
    </message>
    <message>
        <source>colours land within %1 of their places</source>
        <translation>as cores caem a até %1 dos seus lugares</translation>
    </message>
    <message>
        <source>±%1 mm (95 %; half of the painted area within ±%2 mm, all within ±%3 mm)</source>
        <translation>±%1 mm (95 %; metade da área pintada dentro de ±%2 mm, tudo dentro de ±%3 mm)</translation>
    </message>
    <message>
        <source>x %1 mm, z %2 mm from the film&apos;s centre: %3</source>
        <translation>x %1 mm, z %2 mm do centro da película: %3</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
</context>
<context>
    <name>SeparateBodies</name>
    <message>
        <source>The body at X %1, Y %2, Z %3 mm</source>
        <translation>O corpo em X %1, Y %2, Z %3 mm</translation>
    </message>
</context>
<context>
    <name>Separation</name>
    <message>
        <source>The white layer is left out: it needs a printer profile with an ICC profile in CMYK</source>
        <translation>A camada branca fica de fora: ela precisa de um perfil de impressora com um perfil ICC em CMYK</translation>
    </message>
    <message>
        <source>The spot colours are left out: they need a printer profile with an ICC profile in CMYK</source>
        <translation>As cores especiais ficam de fora: elas precisam de um perfil de impressora com um perfil ICC em CMYK</translation>
    </message>
</context>
<context>
    <name>Serving</name>
    <message>
        <source>Write the path of a socket, such as /run/user/1000/dipwright.sock, or a port of this computer, such as 127.0.0.1:8137</source>
        <translation>Escreva o caminho de um socket, como /run/user/1000/dipwright.sock, ou uma porta deste computador, como 127.0.0.1:8137</translation>
    </message>
    <message>
        <source>Only addresses of this computer are possible, because the connection is not encrypted. Reach another computer through an SSH tunnel: ssh -L 8137:127.0.0.1:8137 USER@COMPUTER</source>
        <translation>Só endereços deste computador são possíveis, porque a conexão não é criptografada. Alcance outro computador por um túnel SSH: ssh -L 8137:127.0.0.1:8137 USUARIO@COMPUTADOR</translation>
    </message>
    <message>
        <source>The server does not answer (%1). Check that it runs, and the address</source>
        <translation>O servidor não responde (%1). Verifique se ele está rodando e o endereço</translation>
    </message>
    <message>
        <source>The server&apos;s answer is too long</source>
        <translation>A resposta do servidor é longa demais</translation>
    </message>
    <message>
        <source>The server refused the request (%1)</source>
        <translation>O servidor recusou o pedido (%1)</translation>
    </message>
    <message>
        <source>The server says: %1</source>
        <translation>O servidor diz: %1</translation>
    </message>
    <message>
        <source>The project cannot be read: %1</source>
        <translation>O projeto não pode ser lido: %1</translation>
    </message>
    <message>
        <source>The project has %1 MB, and the server allows %2 MB</source>
        <translation>O projeto tem %1 MB, e o servidor permite %2 MB</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>O arquivo não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>The server has no file %1</source>
        <translation>O servidor não tem o arquivo %1</translation>
    </message>
    <message>
        <source>The server&apos;s file %1 is too large</source>
        <translation>O arquivo %1 do servidor é grande demais</translation>
    </message>
    <message>
        <source>The server could not run the job: %1</source>
        <translation>O servidor não conseguiu executar o trabalho: %1</translation>
    </message>
    <message>
        <source>Waiting for the server</source>
        <translation>Aguardando o servidor</translation>
    </message>
    <message>
        <source>On the server: %1</source>
        <translation>No servidor: %1</translation>
    </message>
    <message>
        <source>Sending the project</source>
        <translation>Enviando o projeto</translation>
    </message>
    <message>
        <source>Fetching the results</source>
        <translation>Buscando os resultados</translation>
    </message>
    <message>
        <source>The server&apos;s results do not fit this program. Install the same version of Dipwright on both computers</source>
        <translation>Os resultados do servidor não servem para este programa. Instale a mesma versão do Dipwright nos dois computadores</translation>
    </message>
    <message>
        <source>The server has too many jobs; remove finished ones</source>
        <translation>O servidor tem trabalhos demais; remova os concluídos</translation>
    </message>
</context>
<context>
    <name>ShippedNames</name>
    <message>
        <source>Ideal film, A3</source>
        <translation>Película ideal, A3</translation>
    </message>
    <message>
        <source>Ideal film, A4</source>
        <translation>Película ideal, A4</translation>
    </message>
    <message>
        <source>Soft film, A4, swells by 5 %</source>
        <translation>Película macia, A4, incha 5 %</translation>
    </message>
    <message>
        <source>Pigment printer, borderless, 600 dpi</source>
        <translation>Impressora de pigmento, sem margens, 600 dpi</translation>
    </message>
    <message>
        <source>Office printer, 5 mm margins</source>
        <translation>Impressora de escritório, margens de 5 mm</translation>
    </message>
    <message>
        <source>True size, sRGB</source>
        <translation>Tamanho real, sRGB</translation>
    </message>
    <message>
        <source>Tank with barriers on all sides</source>
        <translation>Tanque com barreiras em todos os lados</translation>
    </message>
    <message>
        <source>Open tank</source>
        <translation>Tanque aberto</translation>
    </message>
    <message>
        <source>Position-based film on the CPU</source>
        <translation>Película baseada em posições na CPU</translation>
    </message>
    <message>
        <source>Position-based film on an NVIDIA GPU</source>
        <translation>Película baseada em posições em GPU NVIDIA</translation>
    </message>
    <message>
        <source>No NVIDIA driver was found on this computer; install one to compute on the GPU.</source>
        <translation>Nenhum driver NVIDIA foi encontrado neste computador; instale um para calcular na GPU.</translation>
    </message>
    <message>
        <source>No NVIDIA GPU was found on this computer.</source>
        <translation>Nenhuma GPU NVIDIA foi encontrada neste computador.</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Tetrahedron</source>
        <translation>Tetraedro</translation>
    </message>
    <message>
        <source>Turtle</source>
        <translation>Tartaruga</translation>
    </message>
    <message>
        <source>Lagoon</source>
        <translation>Lagoa</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>Crepúsculo</translation>
    </message>
    <message>
        <source>Balance</source>
        <translation>Balança</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Cinza</translation>
    </message>
</context>
<context>
    <name>SmallFile</name>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>O arquivo não pode ser lido: %1</translation>
    </message>
    <message>
        <source>The file is larger than %1 MB, too large for this purpose; choose another file</source>
        <translation>O arquivo tem mais de %1 MB, grande demais para este fim; escolha outro arquivo</translation>
    </message>
</context>
<context>
    <name>SnapshotEdits</name>
    <message>
        <source>Take snapshot “%1”</source>
        <translation>Tirar instantâneo “%1”</translation>
    </message>
    <message>
        <source>Remove snapshot “%1”</source>
        <translation>Remover instantâneo “%1”</translation>
    </message>
    <message>
        <source>Restore snapshot “%1”</source>
        <translation>Restaurar instantâneo “%1”</translation>
    </message>
</context>
<context>
    <name>Snapshots</name>
    <message>
        <source>The picture of layer “%1” is no longer in the project&apos;s file</source>
        <translation>A imagem da camada “%1” não está mais no arquivo do projeto</translation>
    </message>
</context>
<context>
    <name>SolverRegistry</name>
    <message>
        <source>Its description has no valid &quot;%1&quot;</source>
        <translation>Sua descrição não tem “%1” válido</translation>
    </message>
    <message>
        <source>Its description cannot be read: %1</source>
        <translation>Sua descrição não pode ser lida: %1</translation>
    </message>
    <message>
        <source>Its description is not valid JSON: %1</source>
        <translation>Sua descrição não é JSON válido: %1</translation>
    </message>
    <message>
        <source>Its module %1 is missing</source>
        <translation>Falta seu módulo %1</translation>
    </message>
    <message>
        <source>Its module cannot be loaded: %1</source>
        <translation>Seu módulo não pode ser carregado: %1</translation>
    </message>
    <message>
        <source>Its module has no entry point %1</source>
        <translation>Seu módulo não tem o ponto de entrada %1</translation>
    </message>
    <message>
        <source>Its module failed at start: %1</source>
        <translation>Seu módulo falhou ao iniciar: %1</translation>
    </message>
    <message>
        <source>Its module failed at start with an unknown exception</source>
        <translation>Seu módulo falhou ao iniciar com uma exceção desconhecida</translation>
    </message>
    <message>
        <source>no plugin was found</source>
        <translation>nenhum plugin foi encontrado</translation>
    </message>
    <message>
        <source>No solver can run here; install one or set DIPWRIGHT_PLUGIN_PATH</source>
        <translation>Nenhum solucionador pode rodar aqui; instale um ou defina DIPWRIGHT_PLUGIN_PATH</translation>
    </message>
    <message>
        <source>There is no such solver; choose one of %1</source>
        <translation>Esse solucionador não existe; escolha um de %1</translation>
    </message>
    <message>
        <source>This solver cannot be used: %1</source>
        <translation>Este solucionador não pode ser usado: %1</translation>
    </message>
    <message>
        <source>It has crashed twice; replace it, or set DIPWRIGHT_RETRY_SOLVERS=1 to try it again</source>
        <translation>Ele falhou duas vezes; substitua-o ou defina DIPWRIGHT_RETRY_SOLVERS=1 para tentar de novo</translation>
    </message>
    <message>
        <source>The &quot;priority&quot; in its description has to be a whole number from -%1 to %1</source>
        <translation>“priority” na descrição dele tem de ser um número inteiro de -%1 a %1</translation>
    </message>
    <message>
        <source>It cannot run here and does not say why; ask its author</source>
        <translation>Ele não pode rodar aqui e não diz por quê; pergunte ao autor</translation>
    </message>
    <message>
        <source>Its description file is too large</source>
        <translation>O arquivo de descrição dele é grande demais</translation>
    </message>
    <message>
        <source>Its description file does not describe a solver</source>
        <translation>O arquivo de descrição dele não descreve um solucionador</translation>
    </message>
    <message>
        <source>Its id may contain only lower-case letters, digits and hyphens</source>
        <translation>Seu id só pode conter letras minúsculas, dígitos e hifens</translation>
    </message>
    <message>
        <source>Other users can write to %1; remove that permission, or move the plugin</source>
        <translation>Outros usuários podem gravar em %1; retire essa permissão ou mova o plugin</translation>
    </message>
    <message>
        <source>Its module must be in the same folder as its description; give the file&apos;s name without a path</source>
        <translation>O módulo dele deve estar na mesma pasta que a descrição; informe o nome do arquivo sem caminho</translation>
    </message>
    <message>
        <source>Its module does not match this program&apos;s solver interface %1, although its description file says that it does; build it again</source>
        <translation>O módulo dele não corresponde à interface de solucionador %1 deste programa, embora o arquivo de descrição afirme que corresponde; compile-o de novo</translation>
    </message>
    <message>
        <source>It handles films of at most %1 points, but this film has %2; choose another solver, or a coarser film</source>
        <translation>Ele processa películas de no máximo %1 pontos, mas esta película tem %2; escolha outro solucionador ou uma película mais grossa</translation>
    </message>
    <message>
        <source>It was built for solver interface %1, but this program has %2 to %3; get the plugin for this version of the program, or build it again</source>
        <translation>Ele foi feito para a interface de solucionador %1, mas este programa tem a %2 até a %3; obtenha o plugin para esta versão do programa ou compile-o de novo</translation>
    </message>
</context>
<context>
    <name>StateDifference</name>
    <message>
        <source>More</source>
        <translation>Mais</translation>
    </message>
    <message>
        <source>Painted in only one state</source>
        <translation>Pintado em só um estado</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Não pintado</translation>
    </message>
    <message>
        <source>The difference needs the dips of both states.</source>
        <translation>A diferença precisa das imersões dos dois estados.</translation>
    </message>
    <message>
        <source>These states have different models, so their sheets cannot be compared.</source>
        <translation>Estes estados têm modelos diferentes; por isso suas folhas não podem ser comparadas.</translation>
    </message>
    <message>
        <source>These states have different numbers of dips, so their sheets cannot be compared.</source>
        <translation>Estes estados têm números diferentes de imersões; por isso suas folhas não podem ser comparadas.</translation>
    </message>
    <message>
        <source>Comparing the sheets</source>
        <translation>Comparando as folhas</translation>
    </message>
    <message>
        <source>Drawing the difference</source>
        <translation>Desenhando a diferença</translation>
    </message>
</context>
<context>
    <name>StateFigures</name>
    <message>
        <source>no result</source>
        <translation>sem resultado</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>igual</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Total coverage</source>
        <translation>Cobertura total</translation>
    </message>
    <message>
        <source>Area with too large a numerical error</source>
        <translation>Área com erro numérico grande demais</translation>
    </message>
    <message>
        <source>Stretch of the film on the part, 95th percentile</source>
        <translation>Estiramento da película na peça, percentil 95</translation>
    </message>
    <message>
        <source>%1 (better)</source>
        <translation>%1 (melhor)</translation>
    </message>
    <message>
        <source>%1 (worse)</source>
        <translation>%1 (pior)</translation>
    </message>
    <message>
        <source>Largest stretch of the film on the part</source>
        <translation>Maior estiramento da película na peça</translation>
    </message>
    <message>
        <source>Numerical error of the sheet, 95th percentile</source>
        <translation>Erro numérico da folha, percentil 95</translation>
    </message>
    <message>
        <source>Compressed film that may wrinkle</source>
        <translation>Película comprimida que pode enrugar</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Ar preso</translation>
    </message>
    <message>
        <source>Area painted by film that tore, was released or did not converge</source>
        <translation>Área pintada por película que rasgou, se soltou ou não convergiu</translation>
    </message>
    <message>
        <source>Area too pale because of the ink limit</source>
        <translation>Área clara demais por causa do limite de tinta</translation>
    </message>
    <message>
        <source>Length of the seam</source>
        <translation>Comprimento da emenda</translation>
    </message>
    <message>
        <source>Ink of all plates, as area at full tint</source>
        <translation>Tinta de todas as chapas, como área a 100 %</translation>
    </message>
</context>
<context>
    <name>TankFit</name>
    <message>
        <source>The film measures %1 × %2 mm on the water, but the tank “%3” only %4 × %5 mm; use a smaller film</source>
        <translation>Na água, a película mede %1 × %2 mm, mas o tanque “%3” só %4 × %5 mm; use uma película menor</translation>
    </message>
    <message>
        <source>The part reaches past the edge of the tank “%1”; move or turn the part</source>
        <translation>A peça ultrapassa a borda do tanque “%1”; mova ou gire a peça</translation>
    </message>
    <message>
        <source>The part goes %1 mm under water, but the water in the tank “%2” is only %3 mm deep; reduce the depth of the dip, or turn the part</source>
        <translation>A peça desce %1 mm na água, mas a água do tanque “%2” tem só %3 mm de profundidade; reduza a profundidade da imersão ou gire a peça</translation>
    </message>
    <message>
        <source>The centre of the part moves %1 mm sideways from the middle of the tank “%2”, but its machine reaches only %3 mm; move the part or change its path</source>
        <translation>O centro da peça se move %1 mm para o lado a partir do meio do tanque “%2”, mas a máquina alcança só %3 mm; mova a peça ou mude o percurso</translation>
    </message>
    <message>
        <source>The part moves at up to %1 mm/s, but the machine of the tank “%2” reaches only %3 mm/s; reduce the speed of the dip</source>
        <translation>A peça se move a até %1 mm/s, mas a máquina do tanque “%2” chega só a %3 mm/s; reduza a velocidade da imersão</translation>
    </message>
    <message>
        <source>The part turns at up to %1°/s, but the machine of the tank “%2” reaches only %3°/s; use a slower dip or a smaller turn</source>
        <translation>A peça gira a até %1°/s, mas a máquina do tanque “%2” chega só a %3°/s; use uma imersão mais lenta ou um giro menor</translation>
    </message>
    <message>
        <source>The water carries the film %1 mm during the dip, past the edge of the tank “%2”; reduce the speed of the water, or use a smaller film</source>
        <translation>A água leva a película %1 mm durante a imersão, além da borda do tanque “%2”; reduza a velocidade da água ou use uma película menor</translation>
    </message>
    <message>
        <source>The part reaches past the barrier at the film&apos;s %1 edge; move or turn the part, change its path, or use a larger film</source>
        <translation>A peça ultrapassa a barreira na borda %1 da película; mova ou gire a peça, mude o percurso ou use uma película maior</translation>
    </message>
    <message>
        <source>left</source>
        <comment>edge of the film</comment>
        <translation>esquerda</translation>
    </message>
    <message>
        <source>right</source>
        <comment>edge of the film</comment>
        <translation>direita</translation>
    </message>
    <message>
        <source>top</source>
        <comment>edge of the film</comment>
        <translation>superior</translation>
    </message>
    <message>
        <source>bottom</source>
        <comment>edge of the film</comment>
        <translation>inferior</translation>
    </message>
</context>
<context>
    <name>Tolerance</name>
    <message>
        <source>Swell</source>
        <translation>Inchamento</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Nível da água</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxação</translation>
    </message>
    <message>
        <source>Zone %1 is not painted.</source>
        <translation>A zona %1 não é pintada.</translation>
    </message>
    <message>
        <source>Position of the part along X</source>
        <translation>Posição da peça ao longo de X</translation>
    </message>
    <message>
        <source>Position of the part along Z</source>
        <translation>Posição da peça ao longo de Z</translation>
    </message>
    <message>
        <source>Rotation of the part about X</source>
        <translation>Rotação da peça em torno de X</translation>
    </message>
    <message>
        <source>Rotation of the part about Y</source>
        <translation>Rotação da peça em torno de Y</translation>
    </message>
    <message>
        <source>Rotation of the part about Z</source>
        <translation>Rotação da peça em torno de Z</translation>
    </message>
    <message>
        <source>Position of the film along X</source>
        <translation>Posição da película ao longo de X</translation>
    </message>
    <message>
        <source>Position of the film along Z</source>
        <translation>Posição da película ao longo de Z</translation>
    </message>
    <message>
        <source>Rotation of the film about Y</source>
        <translation>Rotação da película em torno de Y</translation>
    </message>
    <message>
        <source>The simulation became unstable in a dip with deviations; give the film smaller cells or more points</source>
        <translation>A simulação ficou instável em uma imersão com desvios; dê à película células menores ou mais pontos</translation>
    </message>
    <message>
        <source>Simulating dips with deviations</source>
        <translation>Simulando imersões com desvios</translation>
    </message>
    <message>
        <source>Check: with all deviations at once, %1 simulated dips give a displacement of ±%2 (95 % of the painted area). The sum of the contributors gives ±%3. Both agree.</source>
        <translation>Verificação: com todos os desvios ao mesmo tempo, %1 imersões simuladas dão um deslocamento de ±%2 (95 % da área pintada). A soma das contribuições dá ±%3. Os dois coincidem.</translation>
    </message>
    <message>
        <source>Check: with all deviations at once, %1 simulated dips give a displacement of ±%2 (95 % of the painted area). The sum of the contributors gives ±%3. The two differ, because the effects of the contributors do not simply add up here.</source>
        <translation>Verificação: com todos os desvios ao mesmo tempo, %1 imersões simuladas dão um deslocamento de ±%2 (95 % da área pintada). A soma das contribuições dá ±%3. Os dois diferem, porque aqui as contribuições não se somam simplesmente.</translation>
    </message>
    <message>
        <source>Zone %1 keeps its limit of ±%3: on %2 % of the painted area, the image is displaced by less than this limit, and on 95 % by ±%4 or less. Largest contributor: %5.</source>
        <translation>A zona %1 respeita seu limite de ±%3: em %2 % da área pintada, a imagem se desloca menos que esse limite, e em 95 %, no máximo ±%4. Maior contribuição: %5.</translation>
    </message>
    <message>
        <source>Zone %1 exceeds its limit of ±%3: on only %2 % of the painted area, the image is displaced by less than this limit, and on 95 % by ±%4 or less. Largest contributor: %5.</source>
        <translation>A zona %1 ultrapassa seu limite de ±%3: em só %2 % da área pintada, a imagem se desloca menos que esse limite, e em 95 %, no máximo ±%4. Maior contribuição: %5.</translation>
    </message>
    <message>
        <source>Angle of the path</source>
        <translation>Ângulo do percurso</translation>
    </message>
    <message>
        <source>Start of the dip</source>
        <translation>Início da imersão</translation>
    </message>
</context>
<context>
    <name>Traveller</name>
    <message>
        <source>The cradle is marked with the number of this dip and the number of its sheet, %1. At the end of the path, its arrow points to the film&apos;s upper edge.</source>
        <translation>O berço traz o número desta imersão e o número da sua folha, %1. No fim do percurso, a seta aponta para a borda superior da película.</translation>
    </message>
    <message>
        <source>Dip the part along its path in %1 s (motion-%2.csv begins at the waiting height). Each pose gives the time, the position of the part&apos;s centre relative to the film&apos;s centre on the water, and the turn relative to the rotation at the end: about the axis to the right, then about the axis towards the upper edge, then about the upward axis.</source>
        <translation>Mergulhar a peça pelo seu percurso em %1 s (motion-%2.csv começa na altura de espera). Cada pose dá o tempo, a posição do centro da peça em relação ao centro da película na água e o giro em relação à rotação no fim: em torno do eixo para a direita, depois do eixo para a borda superior, depois do eixo para cima.</translation>
    </message>
    <message>
        <source>%1 s: %2 mm to the right, %3 mm towards the upper edge, %4 mm up, turned by %5°, %6° and %7°</source>
        <translation>%1 s: %2 mm para a direita, %3 mm para a borda superior, %4 mm para cima, girada em %5°, %6° e %7°</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>não informado</translation>
    </message>
    <message>
        <source>Dip %1 of %2: %3</source>
        <translation>Imersão %1 de %2: %3</translation>
    </message>
    <message>
        <source>%1. %2, job %3</source>
        <translation>%1. %2, trabalho %3</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Trabalho %1</translation>
    </message>
    <message>
        <source>Seen from the film&apos;s lower edge</source>
        <translation>Visto da borda inferior da película</translation>
    </message>
    <message>
        <source>Seen from the film&apos;s right edge</source>
        <translation>Visto da borda direita da película</translation>
    </message>
    <message>
        <source>upper edge</source>
        <translation>borda superior</translation>
    </message>
    <message>
        <source>lower edge</source>
        <translation>borda inferior</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>borda esquerda</translation>
    </message>
    <message>
        <source>No film profile is given.</source>
        <translation>Nenhum perfil de película foi informado.</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>No tanque</translation>
    </message>
    <message>
        <source>Done by</source>
        <translation>Feito por</translation>
    </message>
    <message>
        <source>Date, time</source>
        <translation>Data, hora</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>Conferido por</translation>
    </message>
    <message>
        <source>Swell measured on %1.</source>
        <translation>Inchamento medido em %1.</translation>
    </message>
    <message>
        <source>Swell guessed, not measured.</source>
        <translation>Inchamento estimado, não medido.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Veredito: %1</translation>
    </message>
    <message>
        <source>Soak the film: %1</source>
        <translation>Deixar a película de molho: %1</translation>
    </message>
    <message>
        <source>Spray the activator, then wait: %1</source>
        <translation>Borrifar o ativador, depois esperar: %1</translation>
    </message>
    <message>
        <source>see the film maker&apos;s instructions (no time given)</source>
        <translation>veja as instruções do fabricante da película (tempo não informado)</translation>
    </message>
    <message>
        <source>Traveller for %1, %2</source>
        <translation>Ficha de acompanhamento de %1, %2</translation>
    </message>
    <message>
        <source>Order of the dips: %1</source>
        <translation>Ordem das imersões: %1</translation>
    </message>
    <message>
        <source>Rotation about fixed axes: X %1°, then Y %2°, then Z %3°. Centre of the part: x = %4 mm (to the right), z = %5 mm (towards the lower edge) from the film&apos;s centre. Blue line: water when the dip begins (solid) and ends (dashed).</source>
        <translation>Rotação em torno de eixos fixos: X %1°, depois Y %2°, depois Z %3°. Centro da peça: x = %4 mm (para a direita), z = %5 mm (em direção à borda inferior) do centro da película. Linha azul: água no início da imersão (contínua) e no fim (tracejada).</translation>
    </message>
    <message>
        <source>There is no cradle for this dip. Hold the part as drawn.</source>
        <translation>Não há berço para esta imersão. Segure a peça como no desenho.</translation>
    </message>
    <message>
        <source>The cradle is marked with the number of this dip and the number of its sheet, %1. Its arrow points to the film&apos;s upper edge.</source>
        <translation>O berço traz o número desta imersão e o número da sua folha, %1. A seta aponta para a borda superior da película.</translation>
    </message>
    <message>
        <source>Dotted: the tank&apos;s marks, %1 × %2 mm apart. Centre the film between them.</source>
        <translation>Pontilhado: as marcas do tanque, a %1 × %2 mm. Centralize a película entre elas.</translation>
    </message>
    <message>
        <source>The distance between the tank&apos;s marks is not given.</source>
        <translation>A distância entre as marcas do tanque não foi informada.</translation>
    </message>
    <message>
        <source>Film: printed size %1 × %2 mm, swell %3 × %4.</source>
        <translation>Película: tamanho impresso %1 × %2 mm, inchamento %3 × %4.</translation>
    </message>
    <message>
        <source>%1 (lot: %2, use by: %3).</source>
        <translation>%1 (lote: %2, válido até: %3).</translation>
    </message>
    <message>
        <source>Lay sheet %1 on the water, ink side up.</source>
        <translation>Pôr a folha %1 na água, lado da tinta para cima.</translation>
    </message>
    <message>
        <source>The arrow on the cradle&apos;s plate must point to the upper edge of the sheet.</source>
        <translation>A seta na placa do berço deve apontar para a borda superior da folha.</translation>
    </message>
    <message>
        <source>Dip the part: lower its lowest point from %1 mm above the water to %2 mm below it, at %3 mm/s, in %4 s</source>
        <translation>Mergulhar a peça: baixar seu ponto mais baixo de %1 mm acima da água até %2 mm abaixo dela, a %3 mm/s, em %4 s</translation>
    </message>
    <message>
        <source>Hold the part under water for %1 s. Clear the remaining film from the water around it. Then lift the part out at %2 mm/s.</source>
        <translation>Manter a peça debaixo d&apos;água por %1 s. Retirar da água o resto da película ao redor dela. Depois levantar a peça a %2 mm/s.</translation>
    </message>
    <message>
        <source>Let the part flash off before rinsing: %1</source>
        <translation>Deixar o solvente evaporar da peça antes de enxaguar: %1</translation>
    </message>
    <message>
        <source>Rinse the part, then let it dry: %1</source>
        <translation>Enxaguar a peça, depois deixar secar: %1</translation>
    </message>
    <message>
        <source>Before dip %1, compare the part with its pictures after dip %2: the colours are in place, nothing is torn or folded, and the part is dry where it will be held.</source>
        <translation>Antes da imersão %1, comparar a peça com as imagens dela após a imersão %2: as cores estão no lugar, nada está rasgado ou dobrado, e a peça está seca onde será segurada.</translation>
    </message>
    <message>
        <source>Compare the part with its pictures after dip %1.</source>
        <translation>Comparar a peça com as imagens dela após a imersão %1.</translation>
    </message>
    <message>
        <source>After dip %1 the part should look like this (seen from the lower edge, the right edge and below)</source>
        <translation>Após a imersão %1 a peça deve ficar assim (vista da borda inferior, da borda direita e de baixo)</translation>
    </message>
    <message>
        <source>The part at the end of the dip, when its rotation about fixed axes is X %1°, then Y %2°, then Z %3°. Dashed blue line: water at the end.</source>
        <translation>A peça no fim da imersão, quando sua rotação em torno de eixos fixos é X %1°, depois Y %2°, depois Z %3°. Linha azul tracejada: água no fim.</translation>
    </message>
    <message>
        <source>Tape the masked surface</source>
        <translation>Cobrir a superfície mascarada</translation>
    </message>
    <message>
        <source>Lay the film</source>
        <translation>Pôr a película</translation>
    </message>
    <message>
        <source>Soak</source>
        <translation>Deixar de molho</translation>
    </message>
    <message>
        <source>Spray the activator</source>
        <translation>Borrifar o ativador</translation>
    </message>
    <message>
        <source>Dip the part</source>
        <translation>Mergulhar a peça</translation>
    </message>
    <message>
        <source>Hold under water</source>
        <translation>Manter debaixo da água</translation>
    </message>
    <message>
        <source>Let it flash off</source>
        <translation>Deixar evaporar</translation>
    </message>
    <message>
        <source>Rinse and dry</source>
        <translation>Enxaguar e secar</translation>
    </message>
    <message>
        <source>Remove the tape</source>
        <translation>Tirar a fita</translation>
    </message>
    <message>
        <source>Compare the part</source>
        <translation>Comparar a peça</translation>
    </message>
    <message>
        <source>Cover the masked surface of the part with tape (pink in the pictures). Number of areas: %1; in total %2 mm².</source>
        <translation>Cubra com fita a superfície mascarada da peça (rosa nas figuras). Número de áreas: %1; no total %2 mm².</translation>
    </message>
    <message>
        <source>Check that the tape still covers the masked surface (pink in the pictures).</source>
        <translation>Verifique se a fita ainda cobre a superfície mascarada (rosa nas figuras).</translation>
    </message>
    <message>
        <source>Remove the tape from the masked surface.</source>
        <translation>Retire a fita da superfície mascarada.</translation>
    </message>
    <message>
        <source>Compare the part with the picture on the traveller: the colours are in place, and nothing is torn or folded.</source>
        <translation>Compare a peça com a imagem na ficha de acompanhamento: as cores estão no lugar, e nada está rasgado ou dobrado.</translation>
    </message>
    <message>
        <source>Lay sheet %1, which must have been printed in %2 passes, on the water, ink side up.</source>
        <translation>Ponha a folha %1, que deve ter sido impressa em %2 passadas, sobre a água, com a tinta para cima.</translation>
    </message>
    <message>
        <source>All dips: %1</source>
        <translation>Todas as imersões: %1</translation>
    </message>
    <message>
        <source>From above, ink side up. Crosses: marks of the floating film, or its corners if it has no marks. Red circles: datum pins at (x; z) = %1, %2 and %3 mm from the film&apos;s centre, x to the right, z towards the lower edge. Dashed: the part.</source>
        <translation>De cima, lado da tinta para cima. Cruzes: marcas da película flutuando, ou seus cantos se não tiver marcas. Círculos vermelhos: pinos de referência em (x; z) = %1, %2 e %3 mm do centro da película, x para a direita, z em direção à borda inferior. Tracejado: a peça.</translation>
    </message>
    <message>
        <source>The water flows at %1 mm/s with the heading %2° (0°: to the right, 90°: towards the lower edge) and carries the film. Lay the film so far upstream that its centre is in the middle of the tank when the dip begins; all positions are relative to that place. At the end of the dip, the film&apos;s centre is %3 mm to the right of it and %4 mm towards the lower edge.</source>
        <translation>A água corre a %1 mm/s na direção %2° (0°: para a direita, 90°: para a borda inferior) e leva a película. Coloque a película tão a montante que seu centro esteja no meio do tanque quando a imersão começar; todas as posições são relativas a esse lugar. No fim da imersão, o centro da película está %3 mm à direita dele e %4 mm em direção à borda inferior.</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source> in</source>
        <translation> pol</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> in/s</source>
        <translation> pol/s</translation>
    </message>
    <message>
        <source> mm/s</source>
        <translation> mm/s</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source> cells</source>
        <translation> células</translation>
    </message>
    <message>
        <source> D</source>
        <translation> D</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> %/s</source>
        <translation> %/s</translation>
    </message>
    <message>
        <source>%1 in²</source>
        <translation>%1 pol²</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source> million</source>
        <translation> milhões</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source> in/s²</source>
        <translation> pol/s²</translation>
    </message>
    <message>
        <source> mm/s²</source>
        <translation> mm/s²</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>The film&apos;s swell is %1; the usual range is %2 to %3. Check this value. If it was measured, check that the rulers on the card and on the film have the length that is printed beside them.</source>
        <translation>O inchamento da película é %1; o usual é de %2 a %3. Verifique este valor. Se ele foi medido, verifique se as réguas no cartão e na película têm o comprimento impresso ao lado delas.</translation>
    </message>
    <message>
        <source>Trapped air keeps %1 % of the part dry; the limit is %2 %. Turn the part so that the air escapes, or drill a vent hole. Vent holes narrower than %3 may not be seen.</source>
        <translation>Ar preso mantém secos %1 % da peça; o limite é %2 %. Gire a peça para que o ar saia, ou faça um furo de respiro. Furos de respiro mais estreitos que %3 podem não ser vistos.</translation>
    </message>
    <message>
        <source>The film grows by %1 % in all; more than %2 % is unusual. Check this value.</source>
        <translation>A película cresce %1 % no total; mais de %2 % é incomum. Verifique este valor.</translation>
    </message>
    <message>
        <source>The film grows by %1 % per second; more than %2 % is unusual. Check this value.</source>
        <translation>A película cresce %1 % por segundo; mais de %2 % é incomum. Verifique este valor.</translation>
    </message>
    <message>
        <source>The dip speed is %1 mm/s; the usual range is %2 to %3 mm/s. Check this value.</source>
        <translation>A velocidade da imersão é %1 mm/s; o usual é de %2 a %3 mm/s. Verifique este valor.</translation>
    </message>
    <message>
        <source>The path lifts the part again by more than %1 % of its depth. Film that the part carries out of the water is not simulated. Lower the part without lifting it, or make a test dip.</source>
        <translation>O percurso levanta a peça de novo em mais de %1 % da sua profundidade. Película que a peça leva para fora da água não é simulada. Abaixe a peça sem levantá-la, ou faça uma imersão de teste.</translation>
    </message>
    <message>
        <source>Ink now: %1</source>
        <translation>Tinta agora: %1</translation>
    </message>
    <message>
        <source>A second dip may help, too.</source>
        <translation>Uma segunda imersão também pode ajudar.</translation>
    </message>
    <message>
        <source>The film tears, and up to %1 % of the surface that it should paint stays bare; the limit is %2 %. Turn the part, or use a film that stretches more.</source>
        <translation>A película se rasga, e até %1 % da superfície que ela deve pintar ficam sem tinta; o limite é %2 %. Gire a peça ou use uma película que se estique mais.</translation>
    </message>
    <message>
        <source>The film tore or was released on %1 % of the painted area; the limit is %2 %. Turn the part.</source>
        <translation>A película rasgou ou se soltou em %1 % da área pintada; o limite é %2 %. Gire a peça.</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Turn the part, or set much smaller cells or more points (Film &gt; Resolution).</source>
        <translation>Erro numérico: no máximo %1 em 95 % da área pintada; o limite é %2. Gire a peça ou ponha células bem menores ou mais pontos (Película &gt; Resolução).</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Turn the part.</source>
        <translation>Erro numérico: no máximo %1 em 95 % da área pintada; o limite é %2. Gire a peça.</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Set cells of %3 (Film &gt; Resolution &gt; Cell size), or turn the part.</source>
        <translation>Erro numérico: no máximo %1 em 95 % da área pintada; o limite é %2. Ponha células de %3 (Película &gt; Resolução &gt; Tamanho das células) ou gire a peça.</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Set more points (Film &gt; Points), or turn the part.</source>
        <translation>Erro numérico: no máximo %1 em 95 % da área pintada; o limite é %2. Ponha mais pontos (Película &gt; Pontos) ou gire a peça.</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Não avaliado</translation>
    </message>
    <message>
        <source>Print it</source>
        <translation>Pode imprimir</translation>
    </message>
    <message>
        <source>Do not print</source>
        <translation>Não imprima</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Zone %1: %2</source>
        <translation>Zona %1: %2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The numerical error was not estimated.</source>
        <translation>O erro numérico não foi estimado.</translation>
    </message>
    <message>
        <source>The numerical error could not be estimated: %1.</source>
        <translation>O erro numérico não pôde ser estimado: %1.</translation>
    </message>
    <message>
        <source>The model has no texture and no artwork: one plain colour is printed.</source>
        <translation>O modelo não tem textura nem arte: imprime-se uma só cor.</translation>
    </message>
    <message>
        <source>Model: %1</source>
        <translation>Modelo: %1</translation>
    </message>
    <message>
        <source>The film&apos;s swell is guessed, not measured: the picture may be a few per cent too large or too small. Measure the film.</source>
        <translation>O inchamento da película é estimado, não medido: a imagem pode ficar alguns por cento maior ou menor. Meça a película.</translation>
    </message>
    <message>
        <source>Check these places first</source>
        <translation>Verifique primeiro estes lugares</translation>
    </message>
    <message>
        <source>The numerical error may exceed %2 on %1 % of the painted area. Check the places that the program lists.</source>
        <translation>O erro numérico pode ultrapassar %2 em %1 % da área pintada. Verifique os lugares que o programa lista.</translation>
    </message>
    <message>
        <source>The film does not paint the part. Check the model&apos;s unit, its place over the film, and the depth of the dip.</source>
        <translation>A película não pinta a peça. Verifique a unidade do modelo, o lugar dele sobre a película e a profundidade da imersão.</translation>
    </message>
    <message>
        <source>%1 % of the painted area will be too pale; the limit is %2 %. The film stretches more than the ink limit (Ink &gt; Ink limit) can compensate. Turn the part, or choose lighter colours.</source>
        <translation>%1 % da área pintada ficarão claros demais; o limite é %2 %. A película estica mais do que o limite de tinta (Tinta &gt; Limite de tinta) consegue compensar. Gire a peça ou escolha cores mais claras.</translation>
    </message>
    <message>
        <source>%1 % of the part is painted by neither dip; the limit is %2 %. Turn the part in one of the dips.</source>
        <translation>%1 % da peça não são pintados por nenhuma das imersões; o limite é %2 %. Gire a peça em uma das imersões.</translation>
    </message>
    <message>
        <source>%1 % of the overlap is too narrow; the limit is %2 %. A small placement error of the second film shows there. Widen the overlap (Seam &gt; Overlap), or turn the part in one of the dips.</source>
        <translation>%1 % da sobreposição são estreitos demais; o limite é %2 %. Ali aparece um pequeno erro de posição da segunda película. Alargue a sobreposição (Emenda &gt; Sobreposição) ou gire a peça em uma das imersões.</translation>
    </message>
    <message>
        <source>%1: numerical error up to %3; the limit is %2</source>
        <translation>%1: erro numérico de até %3; o limite é %2</translation>
    </message>
    <message>
        <source>%1 % of the zone is not painted; the limit is %2 %. Turn the part so that film reaches it.</source>
        <translation>%1 % da zona não são pintados; o limite é %2 %. Gire a peça de modo que a película alcance a zona.</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area; the limit is %2. Most of this error comes from the length of the steps: set a smaller step (Dipping &gt; Step).</source>
        <translation>Erro numérico: no máximo %1 em 95 % da área pintada; o limite é %2. A maior parte deste erro vem do comprimento dos passos: ponha um passo menor (Imersão &gt; Passo).</translation>
    </message>
    <message>
        <source>Film that paints the part lies only %1 from the film&apos;s edge; at least %2 are required. Use a larger film, or move the part to the film&apos;s centre.</source>
        <translation>Película que pinta a peça fica a apenas %1 da borda da película; são necessários pelo menos %2. Use uma película maior ou leve a peça ao centro dela.</translation>
    </message>
    <message>
        <source>The numerical error is not known, because this dip and the coarser dips for comparison paint no place in common. Set smaller cells (Film &gt; Resolution).</source>
        <translation>O erro numérico é desconhecido, porque esta imersão e as imersões de comparação, com células maiores, não pintam nenhum lugar em comum. Ponha células menores (Película &gt; Resolução).</translation>
    </message>
    <message>
        <source>Numerical error: at most %1 on 95 % of the painted area.</source>
        <translation>Erro numérico: no máximo %1 em 95 % da área pintada.</translation>
    </message>
    <message>
        <source>The border of the painted area is uncertain: with other cells or steps, %1 % of the part changes between painted and unpainted. Set smaller cells (Film &gt; Resolution).</source>
        <translation>A borda da área pintada é incerta: com outras células ou passos, %1 % da peça mudam entre pintado e não pintado. Ponha células menores (Película &gt; Resolução).</translation>
    </message>
    <message>
        <source>In %1 steps of the dip, the film did not converge; the residual force was up to %2 % of the elastic force. Set smaller cells (Film &gt; Resolution).</source>
        <translation>Em %1 passos da imersão, a película não convergiu; a força residual foi de até %2 % da força elástica. Ponha células menores (Película &gt; Resolução).</translation>
    </message>
    <message>
        <source>This verdict is expected: the run repeats the dip with film cells of %1 and judges it again.</source>
        <translation>Este veredito é esperado: a execução repete a imersão com células da película de %1 e julga de novo.</translation>
    </message>
    <message>
        <source>Handling and numerical error together: at most ±%1 on 95 % of the painted area; the limit is ±%2. Reduce the largest cause that the results list under Tolerances, or turn the part.</source>
        <translation>Manuseio e erro numérico juntos: no máximo ±%1 em 95 % da área pintada; o limite é ±%2. Reduza a maior causa que os resultados listam em “Tolerâncias”, ou gire a peça.</translation>
    </message>
    <message>
        <source>The dip paints only %1 % of the part; the limit is %2 %. Check the depth and the pose.</source>
        <translation>A imersão pinta só %1 % da peça; o limite é %2 %. Verifique a profundidade e a pose.</translation>
    </message>
    <message>
        <source>Both dips print %1 % of the part at full strength, so these places become too dark. Split the part between the dips (share.enabled).</source>
        <translation>As duas imersões imprimem %1 % da peça com intensidade total, e esses lugares ficam escuros demais. Divida a peça entre as imersões (share.enabled).</translation>
    </message>
    <message>
        <source>The sheet has no ink: its picture is white or transparent. Check the texture and the artwork.</source>
        <translation>A folha não tem tinta: a imagem é branca ou transparente. Verifique a textura e a arte.</translation>
    </message>
    <message>
        <source>On the part&apos;s own colour, the picture keeps only %1 % of its contrast; at least %2 % are required. Coat the part, print a white layer under the colours, or correct the part colour.</source>
        <translation>Na cor própria da peça, a imagem conserva apenas %1 % do contraste; são exigidos ao menos %2 %. Pinte a peça com uma base, imprima uma camada branca sob as cores ou corrija a cor da peça.</translation>
    </message>
    <message>
        <source>It is not known whether the measured parts by which the sheet is corrected were dipped with the present pose, film, process and model. Check this, or turn the correction off (As built).</source>
        <translation>Não se sabe se as peças medidas pelas quais a folha é corrigida foram mergulhadas com a pose, a película, o processo e o modelo atuais. Verifique isso ou desative a correção (Como saiu).</translation>
    </message>
    <message>
        <source>The sheet is not corrected, because all measured parts were dipped with another pose, film, process or model. Measure a part of the present dip, or turn the correction off (As built).</source>
        <translation>A folha não é corrigida, porque todas as peças medidas foram mergulhadas com outra pose, película, processo ou modelo. Meça uma peça da imersão atual ou desative a correção (Como saiu).</translation>
    </message>
    <message>
        <source>The sheet is corrected without %1 of %2 measured parts, which were dipped with another pose, film, process or model.</source>
        <translation>A folha é corrigida sem %1 de %2 peças medidas, que foram mergulhadas com outra pose, película, processo ou modelo.</translation>
    </message>
    <message>
        <source>%1: the film did not converge there</source>
        <translation>%1: a película não convergiu ali</translation>
    </message>
    <message>
        <source>Masks cover everything that the film would paint. Remove a mask, or turn the part so that the film reaches other places.</source>
        <translation>As máscaras cobrem tudo o que a película pintaria. Remova uma máscara ou gire a peça para que a película alcance outros lugares.</translation>
    </message>
    <message>
        <source>Artwork hides the amounts of ink in the model&apos;s texture, so its colours are printed instead. To print the amounts, put the artwork into the texture.</source>
        <translation>A arte esconde as quantidades de tinta da textura do modelo, por isso são impressas as cores dela. Para imprimir as quantidades, coloque a arte na textura.</translation>
    </message>
    <message>
        <source>%1: the slow speed is %2 mm/s; the usual range is %3 to %4 mm/s. Check this value.</source>
        <translation>%1: a velocidade lenta é %2 mm/s; o usual é de %3 a %4 mm/s. Verifique este valor.</translation>
    </message>
    <message>
        <source>The numerical error of %1 % of the painted area is unknown, because film with larger cells or steps does not reach it; the limit is %2 %. Set smaller cells (Film &gt; Resolution), or turn the part.</source>
        <translation>O erro numérico é desconhecido em %1 % da área pintada, porque a película com células ou passos maiores não a alcança; o limite é %2 %. Defina células menores (Película &gt; Resolução) ou gire a peça.</translation>
    </message>
    <message>
        <source>Half of the overlap is at most %1 wide instead of %2, because the two films do not overlap farther there.</source>
        <translation>Metade da sobreposição tem no máximo %1 de largura em vez de %2, porque as duas películas não se sobrepõem mais ali.</translation>
    </message>
    <message>
        <source>%1 % of the area that seam marks give to one dip is painted by the other dip. Film does not reach it there, or the marks are too small. Turn the part, or change the marks.</source>
        <translation>%1 % da área que as marcas da emenda atribuem a uma imersão é pintada pela outra. A película não a alcança ali, ou as marcas são pequenas demais. Gire a peça ou altere as marcas.</translation>
    </message>
    <message>
        <source>%1: the part moves at %2 mm/s on its path; the usual range is %3 to %4 mm/s. Check the times of the poses.</source>
        <translation>%1: a peça se move a %2 mm/s em seu percurso; a faixa usual é de %3 a %4 mm/s. Verifique os tempos das poses.</translation>
    </message>
    <message>
        <source>%1 more bodies</source>
        <translation>Mais %1 corpos</translation>
    </message>
    <message>
        <source>Only %1 % is painted; the limit is %2 %. Move or turn the body, dip deeper, or set smaller cells if it is small. If it is to stay bare, mask it.</source>
        <translation>Apenas %1 % são pintados; o limite é %2 %. Mova ou gire o corpo, imerja mais fundo ou ponha células menores se ele for pequeno. Se ele deve ficar sem pintura, mascare-o.</translation>
    </message>
</context>
<context>
    <name>VerdictPanel</name>
    <message>
        <source>Setting</source>
        <translation>Configuração</translation>
    </message>
    <message>
        <source>Places to check in %1:</source>
        <translation>Lugares a verificar em %1:</translation>
    </message>
    <message>
        <source>Before the last changes</source>
        <translation>Antes das últimas mudanças</translation>
    </message>
</context>
<context>
    <name>ZoneAppearance</name>
    <message>
        <source>Zone %1, ±%2 mm</source>
        <translation>Zona %1, ±%2 mm</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Não pintado</translation>
    </message>
    <message>
        <source>Pale: well within the limit</source>
        <translation>Pálido: bem dentro do limite</translation>
    </message>
    <message>
        <source>Above the limit</source>
        <translation>Acima do limite</translation>
    </message>
</context>
<context>
    <name>dipwright::Artwork</name>
    <message>
        <source>The picture of the layer “%1”</source>
        <translation>A imagem da camada “%1”</translation>
    </message>
    <message>
        <source>The artwork already has %1 layers, which is the limit; remove one</source>
        <translation>A arte já tem %1 camadas, que é o limite; remova uma</translation>
    </message>
    <message>
        <source>The font %2 of the text “%1” is not installed on this computer, so another font replaces it; install it, or choose an installed font</source>
        <translation>A fonte %2 do texto “%1” não está instalada neste computador e é substituída por outra; instale-a ou escolha uma fonte instalada</translation>
    </message>
    <message>
        <source>The model has no face or material of this name; its names are %1</source>
        <translation>O modelo não tem face nem material com este nome; seus nomes são %1</translation>
    </message>
    <message>
        <source>No installed font has the characters %2 of the text “%1”, so boxes are printed; install a font that has them</source>
        <translation>Nenhuma fonte instalada tem os caracteres %2 do texto “%1”, por isso são impressos retângulos; instale uma fonte que os tenha</translation>
    </message>
    <message>
        <source>The layer “%1” is %2 mm long, but a turn around its axis is only %3 mm, so its sides are cut off; make it smaller</source>
        <translation>A camada “%1” tem %2 mm de comprimento, mas uma volta em torno de seu eixo tem só %3 mm, por isso seus lados são cortados; diminua-a</translation>
    </message>
    <message>
        <source>The layers “%1” and “%2” use the ink %3 with different colours or printing orders. It is printed with the colour and order of “%1”. Give both layers the same colour and order</source>
        <translation>As camadas “%1” e “%2” usam a tinta %3 com cores ou ordens de impressão diferentes. Ela é impressa com a cor e a ordem de “%1”. Dê às duas camadas a mesma cor e ordem</translation>
    </message>
    <message>
        <source>The layer “%1” ends where another body of the model covers the surface, so about %2 % of it is missing; join the bodies in a modelling program, or place the layer along an axis</source>
        <translation>A camada “%1” termina onde outro corpo do modelo cobre a superfície, por isso faltam cerca de %2 % dela; una os corpos em um programa de modelagem ou posicione a camada ao longo de um eixo</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkController</name>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Carbon</source>
        <translation>Carbono</translation>
    </message>
    <message>
        <source>Camouflage</source>
        <translation>Camuflagem</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Madeira</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Adicionar %1</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Lendo a imagem</translation>
    </message>
    <message>
        <source>Change layer</source>
        <translation>Alterar camada</translation>
    </message>
    <message>
        <source>Change base colour</source>
        <translation>Alterar cor de base</translation>
    </message>
    <message>
        <source>Add picture</source>
        <translation>Adicionar imagem</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Mover camada</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Remover camada</translation>
    </message>
    <message>
        <source>Turn layer</source>
        <translation>Girar camada</translation>
    </message>
    <message>
        <source>Resize layer</source>
        <translation>Redimensionar camada</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkPage</name>
    <message>
        <source>Carbon</source>
        <translation>Carbono</translation>
    </message>
    <message>
        <source>Camouflage</source>
        <translation>Camuflagem</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Madeira</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Para cima</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Para baixo</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>Removes the layer (Delete)</source>
        <translation>Remove a camada (Delete)</translation>
    </message>
    <message>
        <source>Base colour</source>
        <translation>Cor de base</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Fonte</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Cor</translation>
    </message>
    <message>
        <source>Light colour</source>
        <translation>Cor clara</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidade</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>As a decal</source>
        <translation>Como decalque</translation>
    </message>
    <message>
        <source>Along an axis</source>
        <translation>Ao longo de um eixo</translation>
    </message>
    <message>
        <source>From six sides</source>
        <translation>De seis lados</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eixo</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Add &amp;picture…</source>
        <translation>Adicionar &amp;imagem…</translation>
    </message>
    <message>
        <source>Places a picture on the part. You can also drop a picture on the part in the view.</source>
        <translation>Põe uma imagem sobre a peça. Você também pode soltar uma imagem sobre a peça na vista.</translation>
    </message>
    <message>
        <source>Add &amp;text</source>
        <translation>Adicionar &amp;texto</translation>
    </message>
    <message>
        <source>Add p&amp;attern</source>
        <translation>Adicionar p&amp;adrão</translation>
    </message>
    <message>
        <source>Layers, top layer first</source>
        <translation>Camadas, a de cima primeiro</translation>
    </message>
    <message>
        <source>The layers, top layer first. The tick shows or hides a layer, a double click renames it. Delete removes it, Ctrl+Up and Ctrl+Down move it.</source>
        <translation>As camadas, a de cima primeiro. A marca mostra ou esconde uma camada, um clique duplo muda o nome. Delete a remove, Ctrl+Cima e Ctrl+Baixo a movem.</translation>
    </message>
    <message>
        <source>Moves the layer up (Ctrl+Up)</source>
        <translation>Move a camada para cima (Ctrl+Cima)</translation>
    </message>
    <message>
        <source>Moves the layer down (Ctrl+Down)</source>
        <translation>Move a camada para baixo (Ctrl+Baixo)</translation>
    </message>
    <message>
        <source>Each number gives a different pattern of the same kind.</source>
        <translation>Cada número dá um padrão diferente do mesmo tipo.</translation>
    </message>
    <message>
        <source>At 100 % the layer hides everything below it.</source>
        <translation>Com 100 % a camada esconde tudo o que está abaixo.</translation>
    </message>
    <message>
        <source>Spot colour</source>
        <translation>Cor especial</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhuma</translation>
    </message>
    <message>
        <source>Display colour</source>
        <translation>Cor de exibição</translation>
    </message>
    <message>
        <source>On the outside</source>
        <translation>Por fora</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Posicionamento</translation>
    </message>
    <message>
        <source>Around an axis</source>
        <translation>Em torno de um eixo</translation>
    </message>
    <message>
        <source>The layer fits into this width and height and keeps its proportions.</source>
        <translation>A camada cabe nesta largura e altura e mantém suas proporções.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotação</translation>
    </message>
    <message>
        <source>Counterclockwise, seen from outside.</source>
        <translation>No sentido anti-horário, visto de fora.</translation>
    </message>
    <message>
        <source>Repeat width</source>
        <translation>Largura da repetição</translation>
    </message>
    <message>
        <source>no repeat</source>
        <translation>sem repetição</translation>
    </message>
    <message>
        <source>Centre X</source>
        <translation>Centro X</translation>
    </message>
    <message>
        <source>Centre Y</source>
        <translation>Centro Y</translation>
    </message>
    <message>
        <source>Centre Z</source>
        <translation>Centro Z</translation>
    </message>
    <message>
        <source>colours of the model</source>
        <translation>cores do modelo</translation>
    </message>
    <message>
        <source>The name of a varnish or special ink, as the printer knows it. In CMYK PDF and TIFF files the layer then becomes a plate of its own. The plate uses the layer&apos;s shape and opacity, not its colours.</source>
        <translation>O nome de um verniz ou tinta especial, como a impressora o conhece. Em arquivos PDF e TIFF em CMYK, a camada se torna então uma chapa própria. A chapa usa a forma e a opacidade da camada, não as cores.</translation>
    </message>
    <message>
        <source>If ticked, this ink prints before the four process inks and ends up on the outside of the part, like a varnish. Otherwise it prints after the process inks and lies next to the part.</source>
        <translation>Se marcado, esta tinta é impressa antes das quatro tintas de processo e fica no lado de fora da peça, como um verniz. Senão é impressa depois das tintas de processo e fica junto da peça.</translation>
    </message>
    <message>
        <source>A decal keeps lengths and straight lines around its centre. The other placements suit patterns that cover the whole part.</source>
        <translation>Um decalque mantém comprimentos e linhas retas em torno do seu centro. Os outros posicionamentos servem para padrões que cobrem a peça inteira.</translation>
    </message>
    <message>
        <source>The width of one repeat on the part. Around an axis, the width is adjusted so that a whole number of repeats fits.</source>
        <translation>A largura de uma repetição sobre a peça. Em torno de um eixo, a largura é ajustada para caber um número inteiro de repetições.</translation>
    </message>
    <message>
        <source>The layer&apos;s centre in the model&apos;s coordinates. A decal is centred at the nearest place on the surface.</source>
        <translation>O centro da camada nas coordenadas do modelo. Um decalque fica no lugar mais próximo da superfície.</translation>
    </message>
    <message>
        <source>The colour below all layers. White: no ink is printed. Without a base colour the model keeps its own colours.</source>
        <translation>A cor abaixo de todas as camadas. Branco: nenhuma tinta é impressa. Sem cor de base o modelo mantém suas próprias cores.</translation>
    </message>
    <message>
        <source>Programs and printers that do not know the spot colour use this colour instead.</source>
        <translation>Programas e impressoras que não conhecem a cor especial usam esta cor no lugar dela.</translation>
    </message>
    <message>
        <source>Printed size</source>
        <translation>Tamanho impresso</translation>
    </message>
    <message>
        <source>The size of the layer on the part. It keeps its proportions, so it can be smaller than the width and height above.</source>
        <translation>O tamanho da camada na peça. Ela mantém as proporções e, por isso, pode ser menor que a largura e a altura acima.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Only on</source>
        <translation>Somente em</translation>
    </message>
    <message>
        <source>whole part</source>
        <translation>peça inteira</translation>
    </message>
    <message>
        <source>The face of the CAD model, or the material, on which the layer shows. A decal moves to its middle.</source>
        <translation>A face do modelo CAD, ou o material, em que a camada aparece. Um decalque vai para o meio dela.</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkPainter</name>
    <message>
        <source>Painting the artwork</source>
        <translation>Pintando a arte</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyHandles</name>
    <message>
        <source>Turn part</source>
        <translation>Girar peça</translation>
    </message>
    <message>
        <source>Change depth</source>
        <translation>Alterar profundidade</translation>
    </message>
    <message>
        <source>Move part</source>
        <translation>Mover peça</translation>
    </message>
    <message>
        <source>Turned by %1° about %2 (type an angle, or hold Shift for steps of %3°)</source>
        <translation>Girado %1° em torno de %2 (digite um ângulo ou segure Shift para passos de %3°)</translation>
    </message>
    <message>
        <source>Moved to %1 along %2 (type a distance, or hold Shift for steps of %3)</source>
        <translation>Movido para %1 ao longo de %2 (digite uma distância ou segure Shift para passos de %3)</translation>
    </message>
    <message>
        <source>Depth %1 (type a distance, or hold Shift for steps of %2)</source>
        <translation>Profundidade %1 (digite uma distância ou segure Shift para passos de %2)</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyMenu</name>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Girar</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Mover</translation>
    </message>
    <message>
        <source>Mark this face as &amp;zone A</source>
        <translation>Marcar esta face como &amp;zona A</translation>
    </message>
    <message>
        <source>Turn part</source>
        <translation>Girar peça</translation>
    </message>
    <message>
        <source>Move part</source>
        <translation>Mover peça</translation>
    </message>
    <message>
        <source>Turn this face &amp;down</source>
        <translation>&amp;Virar esta face para baixo</translation>
    </message>
    <message>
        <source>Turn a face down</source>
        <translation>Virar uma face para baixo</translation>
    </message>
    <message>
        <source>Mask this face, so that it &amp;stays free of film</source>
        <translation>Mascarar esta face, para que fique &amp;livre de película</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyShare</name>
    <message>
        <source>Splitting the part between the dips</source>
        <translation>Dividindo a peça entre as imersões</translation>
    </message>
</context>
<context>
    <name>dipwright::Budgets</name>
    <message>
        <source>A face of the model has more than %1 corners; cut it into triangles in a modelling program</source>
        <translation>Uma face do modelo tem mais de %1 cantos; divida-a em triângulos em um programa de modelagem</translation>
    </message>
    <message>
        <source>The model refers to more than %1 other files; reduce their number</source>
        <translation>O modelo se refere a mais de %1 outros arquivos; reduza o número deles</translation>
    </message>
    <message>
        <source>The model has more than %1 materials; reduce their number</source>
        <translation>O modelo tem mais de %1 materiais; reduza o número deles</translation>
    </message>
    <message>
        <source>The file is not opened, because it contains more than %1 entries; ask its author for another file</source>
        <translation>O arquivo não é aberto, porque contém mais de %1 entradas; peça outro arquivo ao autor</translation>
    </message>
    <message>
        <source>project.json is larger than %1 MB and is not read; ask the project&apos;s author for another file</source>
        <translation>project.json é maior que %1 MB e não é lido; peça outro arquivo ao autor do projeto</translation>
    </message>
    <message>
        <source>The file is not read, because its values are nested more than %1 levels deep; ask its author for another file</source>
        <translation>O arquivo não é lido, porque seus valores estão aninhados em mais de %1 níveis; peça outro arquivo ao autor</translation>
    </message>
    <message>
        <source>The file is not read, because it contains more than %1 million values; ask its author for another file</source>
        <translation>O arquivo não é lido, porque contém mais de %1 milhões de valores; peça outro arquivo ao autor</translation>
    </message>
    <message>
        <source>The project contains more than %1 MB of files that do not belong to it; remove them with an archive program</source>
        <translation>O projeto contém mais de %1 MB de arquivos que não pertencem a ele; retire-os com um programa de arquivamento</translation>
    </message>
    <message>
        <source>The file is larger than %1 MB; make it smaller</source>
        <translation>O arquivo é maior que %1 MB; reduza-o</translation>
    </message>
    <message>
        <source>The model has more than %1 million triangles, which is the limit for a file of its size; reduce their number</source>
        <translation>O modelo tem mais de %1 milhões de triângulos, que é o limite para um arquivo deste tamanho; reduza o número deles</translation>
    </message>
    <message>
        <source>The model cannot be read: its objects are nested more than %1 levels deep; merge them in a modelling program</source>
        <translation>O modelo não pode ser lido: seus objetos estão aninhados em mais de %1 níveis; una-os em um programa de modelagem</translation>
    </message>
    <message>
        <source>The file is not opened, because it would take more than %1 MB after unpacking, far too much for its size; ask its author for another file</source>
        <translation>O arquivo não é aberto, porque ocuparia mais de %1 MB depois de descompactado, demais para o seu tamanho; peça outro arquivo ao autor</translation>
    </message>
    <message>
        <source>The picture is more than %1 pixels wide or high; make it smaller</source>
        <translation>A imagem tem mais de %1 pixels de largura ou de altura; diminua-a</translation>
    </message>
    <message>
        <source>The pictures have more than %1 million pixels in total, too many for a file of this size; reduce the pictures in width and height</source>
        <translation>As imagens têm no total mais de %1 milhões de pixels, demais para um arquivo deste tamanho; diminua a largura e a altura das imagens</translation>
    </message>
    <message>
        <source>Reading the file takes more than %1 MB of memory, far too much for its size; make the file smaller, or save it again in the program that created it</source>
        <translation>Ler o arquivo exige mais de %1 MB de memória, demais para o seu tamanho; reduza o arquivo ou salve-o de novo no programa que o criou</translation>
    </message>
    <message>
        <source>Reading the file takes more than %1 seconds, far too long for its size; make the file smaller, or save it again in the program that created it</source>
        <translation>Ler o arquivo leva mais de %1 segundos, demais para o seu tamanho; reduza o arquivo ou salve-o de novo no programa que o criou</translation>
    </message>
    <message>
        <source>The CAD model has more than %1 faces; save only the part that is dipped, without its inner parts</source>
        <translation>O modelo CAD tem mais de %1 faces; salve somente a peça que é imersa, sem as partes internas</translation>
    </message>
    <message>
        <source>The CAD model would have more than %1 million triangles; choose a larger tolerance for its triangles</source>
        <translation>O modelo CAD teria mais de %1 milhões de triângulos; escolha uma tolerância maior para os triângulos</translation>
    </message>
    <message>
        <source>Reading the CAD file takes more than %1 MB of memory; choose a larger tolerance for its triangles, or save only the part that is dipped</source>
        <translation>Ler o arquivo CAD exige mais de %1 MB de memória; escolha uma tolerância maior para os triângulos ou salve somente a peça que é imersa</translation>
    </message>
    <message>
        <source>Reading the CAD file takes more than %1 seconds; choose a larger tolerance for its triangles, or save only the part that is dipped</source>
        <translation>Ler o arquivo CAD leva mais de %1 segundos; escolha uma tolerância maior para os triângulos ou salve somente a peça que é imersa</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltController</name>
    <message>
        <source>Computing the repeating error</source>
        <translation>Calculando o erro que se repete</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Como saiu</translation>
    </message>
    <message>
        <source>Measuring the error on the sheet</source>
        <translation>Medindo o erro na folha</translation>
    </message>
    <message>
        <source>Keep part</source>
        <translation>Guardar peça</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltPage</name>
    <message>
        <source>&amp;Correct the next sheets</source>
        <translation>&amp;Corrigir as próximas folhas</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Accepted by</source>
        <translation>Aceita por</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Strength of the correction</source>
        <translation>Intensidade da correção</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>The repeating error of the parts is shown here.</source>
        <translation>Aqui se vê o erro que se repete nas peças.</translation>
    </message>
    <message>
        <source>Repeating error and correction</source>
        <translation>Erro que se repete e correção</translation>
    </message>
    <message>
        <source>Measured parts of the job</source>
        <translation>Peças medidas do trabalho</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erro</translation>
    </message>
    <message>
        <source>Name of the person who accepts the part</source>
        <translation>Nome da pessoa que aceita a peça</translation>
    </message>
    <message>
        <source>&amp;Keep part</source>
        <translation>&amp;Guardar peça</translation>
    </message>
    <message>
        <source>Stores the measured error of this part with the job</source>
        <translation>Guarda o erro medido desta peça com o trabalho</translation>
    </message>
    <message>
        <source>Shifts the image on the next sheets so that it cancels the repeating error</source>
        <translation>Desloca a imagem nas próximas folhas para anular o erro que se repete</translation>
    </message>
    <message>
        <source>How much of the repeating error the next sheets correct</source>
        <translation>Quanto do erro que se repete as próximas folhas corrigem</translation>
    </message>
    <message>
        <source>The picture shows how the next sheets are corrected.</source>
        <translation>A imagem mostra como as próximas folhas são corrigidas.</translation>
    </message>
    <message>
        <source>Root mean square of the part&apos;s error, measured on the sheet</source>
        <translation>Média quadrática do erro da peça, medida na folha</translation>
    </message>
    <message>
        <source>The correction is off. The picture shows how it would change the next sheets.</source>
        <translation>A correção está desligada. A imagem mostra como ela mudaria as próximas folhas.</translation>
    </message>
    <message>
        <source>“Keep part” stores in the project: the error of this part, the checksums of its photos and the name of the person who accepts it.</source>
        <translation>“Guardar peça” registra no projeto: o erro desta peça, as somas de verificação das suas fotos e o nome da pessoa que a aceita.</translation>
    </message>
    <message>
        <source>To keep a part, first find its corners on the page “Dipped part”. The places of the pairs must lie on the part itself, not on the print.</source>
        <translation>Para guardar uma peça, procure antes os cantos dela na página “Peça mergulhada”. Os lugares dos pares devem estar na própria peça, não na impressão.</translation>
    </message>
    <message>
        <source>Name of the person</source>
        <translation>Nome da pessoa</translation>
    </message>
    <message>
        <source>Times at the tank</source>
        <translation>Tempos no tanque</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>No tanque</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Vezes</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Planejado</translation>
    </message>
    <message>
        <source>Took</source>
        <translation>Levou</translation>
    </message>
    <message>
        <source>Mean of all runs, and the shortest and longest run</source>
        <translation>Média de todas as vezes, e a mais curta e a mais longa</translation>
    </message>
    <message>
        <source>Dip %1: %2</source>
        <translation>Imersão %1: %2</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 a %3)</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconhecido</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sim</translation>
    </message>
    <message>
        <source>no</source>
        <translation>não</translation>
    </message>
    <message>
        <source>only dip %1</source>
        <translation>só a imersão %1</translation>
    </message>
    <message>
        <source>Dips as now</source>
        <translation>Como agora</translation>
    </message>
    <message>
        <source>Whether the part was dipped with the present pose, film, process and model. The next sheets are corrected without dips of which this is not so.</source>
        <translation>Se a peça foi mergulhada com a pose, a película, o processo e o modelo atuais. As próximas folhas são corrigidas sem as imersões em que não é assim.</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltPlaces</name>
    <message>
        <source>None of the measured places lies on film that adheres to the part; check that the photos show a part of this job</source>
        <translation>Nenhum dos lugares medidos fica sobre película aderida à peça; verifique se as fotos mostram uma peça deste trabalho</translation>
    </message>
    <message>
        <source>The job can keep at most %1 parts and %2 places; this part would exceed the limit</source>
        <translation>O trabalho pode guardar no máximo %1 peças e %2 lugares; esta peça passaria do limite</translation>
    </message>
    <message>
        <source>The job already contains the part in these photos; a part may be added only once</source>
        <translation>O trabalho já contém a peça destas fotos; uma peça só pode ser adicionada uma vez</translation>
    </message>
    <message>
        <source>they fit if sheet_y_mm has the other sign: it increases downwards on the floating sheet, ink side up</source>
        <translation>eles se ajustam com o sinal de sheet_y_mm invertido: ele cresce para baixo na folha flutuante, com a tinta para cima</translation>
    </message>
    <message>
        <source>they fit if sheet_x_mm has the other sign: it increases rightwards on the floating sheet, ink side up</source>
        <translation>eles se ajustam com o sinal de sheet_x_mm invertido: ele cresce para a direita na folha flutuante, com a tinta para cima</translation>
    </message>
    <message>
        <source>they fit if sheet_x_mm and sheet_y_mm have the other sign</source>
        <translation>eles se ajustam com os sinais de sheet_x_mm e sheet_y_mm invertidos</translation>
    </message>
    <message>
        <source>they fit if sheet_x_mm and sheet_y_mm are swapped</source>
        <translation>eles se ajustam se sheet_x_mm e sheet_y_mm forem trocados</translation>
    </message>
    <message>
        <source>they fit if they are counted from the sheet&apos;s top left corner; count them from its middle</source>
        <translation>eles se ajustam se contados do canto superior esquerdo da folha; conte a partir do centro</translation>
    </message>
    <message>
        <source>they fit if they are counted from the sheet&apos;s bottom left corner; count them from its middle, downwards</source>
        <translation>eles se ajustam se contados do canto inferior esquerdo da folha; conte a partir do centro, para baixo</translation>
    </message>
    <message>
        <source>check that they belong to this job and its present settings</source>
        <translation>verifique se pertencem a este trabalho e às suas configurações atuais</translation>
    </message>
    <message>
        <source>The simulation carries half of the printed places more than %1 mm away from their targets x_mm, y_mm, z_mm; %2</source>
        <translation>Na simulação, metade dos pontos impressos fica a mais de %1 mm dos seus alvos x_mm, y_mm, z_mm; %2</translation>
    </message>
    <message>
        <source>%1 of %2 places x_mm, y_mm, z_mm lie more than %3 mm from the surface of the job&apos;s model; check that the table belongs to this part, and is in millimetres and in the model&apos;s coordinates</source>
        <translation>%1 de %2 pontos x_mm, y_mm, z_mm ficam a mais de %3 mm da superfície do modelo; verifique se a tabela é desta peça e está em milímetros e nas coordenadas do modelo</translation>
    </message>
</context>
<context>
    <name>dipwright::CadModel</name>
    <message>
        <source>CAD file %1 in %2, faces: %3, tolerance of the triangles: %4 mm</source>
        <translation>Arquivo CAD %1 em %2, faces: %3, tolerância dos triângulos: %4 mm</translation>
    </message>
    <message>
        <source>mm (its unit is unknown)</source>
        <translation>mm (sua unidade é desconhecida)</translation>
    </message>
    <message>
        <source>Only a model from a CAD file (STEP, IGES) can be cut into other triangles; import such a file</source>
        <translation>Somente um modelo de um arquivo CAD (STEP, IGES) pode ser dividido em outros triângulos; importe um arquivo assim</translation>
    </message>
</context>
<context>
    <name>dipwright::CalibrationDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Horizontal ruler</source>
        <translation>Régua horizontal</translation>
    </message>
    <message>
        <source>Vertical ruler</source>
        <translation>Régua vertical</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Salvar como PDF…</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>1. Print the page</source>
        <translation>1. Imprimir a página</translation>
    </message>
    <message>
        <source>P&amp;rofile</source>
        <translation>Pe&amp;rfil</translation>
    </message>
    <message>
        <source>Pr&amp;inter</source>
        <translation>&amp;Impressora</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apel</translation>
    </message>
    <message>
        <source>&amp;Horizontal</source>
        <translation>&amp;Horizontal</translation>
    </message>
    <message>
        <source>&amp;Vertical</source>
        <translation>&amp;Vertical</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Looking for printers</source>
        <translation>Procurando impressoras</translation>
    </message>
    <message>
        <source>X %1, Y %2</source>
        <translation>X %1, Y %2</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Imprimindo</translation>
    </message>
    <message>
        <source>Printed on %1. Let it dry, then measure.</source>
        <translation>Página impressa em %1. Deixe secar e depois meça.</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibração</translation>
    </message>
    <message>
        <source>Wrote %1. Print it at 100 %, without “fit to page”.</source>
        <translation>%1 gravado. Imprima a 100 %, sem “ajustar à página”.</translation>
    </message>
    <message>
        <source>The measured length of the printed ruler, to 0.1 mm.</source>
        <translation>O comprimento medido da régua impressa, até 0,1 mm.</translation>
    </message>
    <message>
        <source>Measure (no correction)</source>
        <translation>Medir (sem correção)</translation>
    </message>
    <message>
        <source>Verify (corrected by the profile)</source>
        <translation>Verificar (corrigida pelo perfil)</translation>
    </message>
    <message>
        <source>&amp;Print page</source>
        <translation>Im&amp;primir página</translation>
    </message>
    <message>
        <source>&amp;Save scale to profile</source>
        <translation>&amp;Guardar escala no perfil</translation>
    </message>
    <message>
        <source>Calibrate printer</source>
        <translation>Calibrar impressora</translation>
    </message>
    <message>
        <source>No printer set up</source>
        <translation>Nenhuma impressora configurada</translation>
    </message>
    <message>
        <source>The profile that receives the scale. You can create profiles under “Profiles”.</source>
        <translation>O perfil que recebe a escala. Novos perfis são criados em “Perfis”.</translation>
    </message>
    <message>
        <source>The paper in the printer.</source>
        <translation>O papel na impressora.</translation>
    </message>
    <message>
        <source>Prints rulers without correction, for measuring.</source>
        <translation>Imprime réguas sem correção, para medir.</translation>
    </message>
    <message>
        <source>2. Measure the rulers</source>
        <translation>2. Medir as réguas</translation>
    </message>
    <message>
        <source>Save page</source>
        <translation>Salvar página</translation>
    </message>
    <message>
        <source>The printers that are set up on this computer.</source>
        <translation>As impressoras configuradas neste computador.</translation>
    </message>
    <message>
        <source>Prints the same rulers with the correction. Each ruler must now have its nominal length.</source>
        <translation>Imprime as mesmas réguas com a correção. Cada régua deve agora ter seu comprimento nominal.</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Save the page as PDF and print it elsewhere, at 100 %.</source>
        <translation>Não há impressora configurada neste computador. Salve a página em PDF e imprima em outro lugar, a 100 %.</translation>
    </message>
    <message>
        <source>nominal length: %1 mm</source>
        <translation>comprimento nominal: %1 mm</translation>
    </message>
    <message>
        <source>Print the page. Measure both rulers from the first to the last line, to 0.1 mm. Type the lengths and save the scale. Then print the page again to verify the scale.</source>
        <translation>Imprima a página. Meça as duas réguas do primeiro ao último traço, até 0,1 mm. Digite os comprimentos e guarde a escala. Depois imprima a página de novo para verificar a escala.</translation>
    </message>
    <message>
        <source>Sent to the print queue of %1</source>
        <translation>Enviado à fila de impressão de %1</translation>
    </message>
    <message>
        <source>%1 now has the scale X %2, Y %3. Print the page again to verify the scale.</source>
        <translation>%1 agora tem a escala X %2, Y %3. Imprima a página de novo para verificar a escala.</translation>
    </message>
</context>
<context>
    <name>dipwright::CalibrationPage</name>
    <message>
        <source>Verification of the printer&apos;s scale</source>
        <translation>Verificação da escala da impressora</translation>
    </message>
    <message>
        <source>Calibration of the printer&apos;s scale</source>
        <translation>Calibração da escala da impressora</translation>
    </message>
    <message>
        <source>The calibration page cannot be written: %1</source>
        <translation>A página de calibração não pode ser gravada: %1</translation>
    </message>
    <message>
        <source>From its first to its last line, the horizontal ruler must measure %1 mm and the vertical ruler %2 mm.</source>
        <translation>Da primeira à última linha, a régua horizontal deve medir %1 mm e a vertical, %2 mm.</translation>
    </message>
    <message>
        <source>If a ruler differs by more than 0.2 mm, calibrate the printer again.</source>
        <translation>Se uma régua diferir em mais de 0,2 mm, calibre a impressora de novo.</translation>
    </message>
    <message>
        <source>Measure both rulers to 0.1 mm and enter the lengths in the printer&apos;s profile.</source>
        <translation>Meça as duas réguas com precisão de 0,1 mm e informe os comprimentos no perfil da impressora.</translation>
    </message>
    <message>
        <source>Scale correction: X %1, Y %2</source>
        <translation>Correção de escala: X %1, Y %2</translation>
    </message>
    <message>
        <source>No scale correction: X 1, Y 1</source>
        <translation>Sem correção de escala: X 1, Y 1</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small to calibrate a printer; use A5 or larger</source>
        <translation>Papel de %1 × %2 mm é pequeno demais para calibrar uma impressora; use A5 ou maior</translation>
    </message>
    <message>
        <source>A ruler of %2 mm measures %1 mm, which differs by more than 10 %; switch off all scaling in the printer&apos;s settings, print the page again and measure again</source>
        <translation>Uma régua de %2 mm mede %1 mm, uma diferença de mais de 10 %; desligue toda escala nas configurações da impressora, imprima a página de novo e meça outra vez</translation>
    </message>
</context>
<context>
    <name>dipwright::CompareWindow</name>
    <message>
        <source>What is shown</source>
        <translation>O que se mostra</translation>
    </message>
    <message>
        <source>Stretch of the film</source>
        <translation>Estiramento da película</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Enquadrar</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progresso</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fechar</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferença</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Lado a lado</translation>
    </message>
    <message>
        <source>Film on the part</source>
        <translation>Película na peça</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>The dip that is shown</source>
        <translation>A imersão mostrada</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>Fit both parts into their views</source>
        <translation>Enquadra as duas peças em suas vistas</translation>
    </message>
    <message>
        <source>Close the comparison (Escape)</source>
        <translation>Fecha a comparação (Escape)</translation>
    </message>
    <message>
        <source>Values of both states</source>
        <translation>Valores dos dois estados</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeza</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Difference on the sheet</source>
        <translation>Diferença na folha</translation>
    </message>
    <message>
        <source>What both views show: the lines of the film, its stretch, the painted area, or how far the image differs between the two states, on the part and on the second sheet</source>
        <translation>O que as duas vistas mostram: as linhas da película, seu estiramento, a área pintada, ou quanto a imagem difere entre os dois estados, na peça e na segunda folha</translation>
    </message>
    <message>
        <source>Difference of the sheets</source>
        <translation>Diferença das folhas</translation>
    </message>
    <message>
        <source>Difference of each dip</source>
        <translation>Diferença de cada imersão</translation>
    </message>
    <message>
        <source>Choose a dip to see the place where its sheets differ most</source>
        <translation>Escolha uma imersão para ver o lugar em que suas folhas mais diferem</translation>
    </message>
    <message>
        <source>95 % of the surface</source>
        <translation>95 % da superfície</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maior</translation>
    </message>
    <message>
        <source>Painted in both</source>
        <translation>Pintado em ambos</translation>
    </message>
    <message>
        <source>Painted in one</source>
        <translation>Pintado em só um</translation>
    </message>
    <message>
        <source>Comparing the sheets</source>
        <translation>Comparando as folhas</translation>
    </message>
    <message>
        <source>Difference on the part</source>
        <translation>Diferença na peça</translation>
    </message>
    <message>
        <source>Difference on the sheet of “%1”</source>
        <translation>Diferença na folha de “%1”</translation>
    </message>
    <message>
        <source>Distance between the places of the flat film that colour a place of the part. Choose a dip in the table to see the place where it is largest.</source>
        <translation>Distância entre os lugares da película plana que pintam um lugar da peça. Escolha uma imersão na tabela para ver o lugar em que ela é maior.</translation>
    </message>
</context>
<context>
    <name>dipwright::CradleView</name>
    <message>
        <source>Making the cradle</source>
        <translation>Fazendo o berço</translation>
    </message>
    <message>
        <source>Show cradle</source>
        <translation>Mostrar berço</translation>
    </message>
</context>
<context>
    <name>dipwright::DeeperFilm</name>
    <message>
        <source>Deeper dip</source>
        <translation>Imersão mais funda</translation>
    </message>
    <message>
        <source>Simulating a deeper dip</source>
        <translation>Simulando uma imersão mais profunda</translation>
    </message>
</context>
<context>
    <name>dipwright::DipCacheUpdater</name>
    <message>
        <source>Reading cached results</source>
        <translation>Lendo resultados em cache</translation>
    </message>
    <message>
        <source>Took the results from the cache file beside the project.</source>
        <translation>Os resultados vieram do arquivo de cache ao lado do projeto.</translation>
    </message>
</context>
<context>
    <name>dipwright::DipController</name>
    <message>
        <source>Simulated with %1 on %2</source>
        <translation>Simulado com “%1” em %2</translation>
    </message>
    <message>
        <source>The results are out of date; run the dip again first.</source>
        <translation>Os resultados estão desatualizados; execute a imersão de novo antes.</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>Use film %1</source>
        <translation>Usar película %1</translation>
    </message>
    <message>
        <source>Out of date: new results are being computed.</source>
        <translation>Desatualizado: novos resultados estão sendo calculados.</translation>
    </message>
    <message>
        <source>Sheet out of date: made before the last changes.</source>
        <translation>Folha desatualizada: feita antes das últimas mudanças.</translation>
    </message>
    <message>
        <source>Results out of date: made before the last changes.</source>
        <translation>Resultados desatualizados: feitos antes das últimas mudanças.</translation>
    </message>
    <message>
        <source>being refined</source>
        <translation>em refinamento</translation>
    </message>
    <message>
        <source>The dip can be played when the running job has ended.</source>
        <translation>A imersão pode ser reproduzida quando o trabalho em andamento terminar.</translation>
    </message>
    <message>
        <source>Draft with %1 × %2 film points</source>
        <translation>Rascunho, %1 × %2 pontos</translation>
    </message>
    <message>
        <source>95 % of the sheet within about %1</source>
        <translation>95 % da folha com erro até %1</translation>
    </message>
    <message>
        <source>run the dip before printing</source>
        <translation>execute a imersão antes de imprimir</translation>
    </message>
    <message>
        <source>The saved results contain no recording of the dip. The dip is simulated again so that you can play it; the results stay the same.</source>
        <translation>Os resultados salvos não contêm uma gravação da imersão. A imersão é simulada de novo para que você possa reproduzi-la; os resultados permanecem iguais.</translation>
    </message>
    <message>
        <source>Refining to reduce the numerical error. Cancel keeps this result.</source>
        <translation>Refinando para reduzir o erro numérico. Cancelar mantém este resultado.</translation>
    </message>
    <message>
        <source>The numerical error is larger than wanted. Run the dip again to refine the film.</source>
        <translation>O erro numérico é maior que o desejado. Execute a imersão novamente para refinar a película.</translation>
    </message>
</context>
<context>
    <name>dipwright::DipScene</name>
    <message>
        <source>Mask: stays free of film</source>
        <translation>Máscara: fica livre de película</translation>
    </message>
</context>
<context>
    <name>dipwright::DipView</name>
    <message>
        <source>The 3D view needs OpenGL 3.2, which could not be started. Update the graphics driver. Everything else works.</source>
        <translation>A vista 3D precisa de OpenGL 3.2, que não pôde ser iniciado. Atualize o driver da placa de vídeo. Todo o resto funciona.</translation>
    </message>
</context>
<context>
    <name>dipwright::DistanceField</name>
    <message>
        <source>The distance field&apos;s resolution is %1; choose 32 to 512</source>
        <translation>A resolução do campo de distância é %1; escolha de 32 a 512</translation>
    </message>
    <message>
        <source>Building the distance field</source>
        <translation>Construindo o campo de distância</translation>
    </message>
    <message>
        <source>The size of the model is zero; choose a model with a surface</source>
        <translation>O tamanho do modelo é zero; escolha um modelo com superfície</translation>
    </message>
</context>
<context>
    <name>dipwright::Document</name>
    <message>
        <source>The project is open elsewhere (%1); choose another name</source>
        <translation>O projeto está aberto em outro lugar (%1); escolha outro nome</translation>
    </message>
</context>
<context>
    <name>dipwright::DocumentController</name>
    <message>
        <source>an unknown machine</source>
        <translation>uma máquina desconhecida</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Sobrescrever</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Abrir projeto</translation>
    </message>
    <message>
        <source>Project in use</source>
        <translation>Projeto em uso</translation>
    </message>
    <message>
        <source>“%1” is already open on %2 (process %3).</source>
        <translation>“%1” já está aberto em %2 (processo %3).</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Abrir mesmo assim</translation>
    </message>
    <message>
        <source>Project changed by another program</source>
        <translation>Projeto alterado por outro programa</translation>
    </message>
    <message>
        <source>Another program has saved “%1” since you opened it.</source>
        <translation>Outro programa salvou “%1” depois que você o abriu.</translation>
    </message>
    <message>
        <source>Save under another name to keep both versions. If you overwrite the file, the changes of the other program are lost.</source>
        <translation>Salve com outro nome para manter as duas versões. Se você sobrescrever o arquivo, as mudanças do outro programa se perdem.</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salvar &amp;como…</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Salvar projeto</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Mudanças não salvas</translation>
    </message>
    <message>
        <source>Save the changes to “%1” before closing it?</source>
        <translation>Salvar as mudanças em “%1” antes de fechar?</translation>
    </message>
    <message>
        <source>No recent projects</source>
        <translation>Nenhum projeto recente</translation>
    </message>
    <message>
        <source>%1 is a picture. Open a project first, then drop the picture to use it as the texture.</source>
        <translation>%1 é uma imagem. Abra primeiro um projeto e depois solte a imagem para usá-la como textura.</translation>
    </message>
    <message>
        <source>%1 is not a project, model or picture</source>
        <translation>%1 não é projeto, modelo nem imagem</translation>
    </message>
    <message>
        <source>If both programs save the project, the one that saves second asks which version to keep.</source>
        <translation>Se os dois programas salvarem o projeto, o segundo a salvar pergunta qual versão manter.</translation>
    </message>
    <message>
        <source>The file of this project no longer exists: %1. Save the project to write it again.</source>
        <translation>O arquivo deste projeto não existe mais: %1. Salve o projeto para gravá-lo de novo.</translation>
    </message>
    <message>
        <source>The file of “%1” no longer exists. Save the project before closing it?</source>
        <translation>O arquivo de “%1” não existe mais. Salvar o projeto antes de fechar?</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Salvamento</translation>
    </message>
    <message>
        <source>“%1” is being saved. The window closes when the project is saved.</source>
        <translation>“%1” está sendo salvo. A janela fecha quando o projeto estiver salvo.</translation>
    </message>
    <message>
        <source>If you cancel, the window stays open. The project is saved in any case.</source>
        <translation>Se você cancelar, a janela continua aberta. O projeto é salvo de qualquer forma.</translation>
    </message>
</context>
<context>
    <name>dipwright::DocumentSession</name>
    <message>
        <source>Opening the project</source>
        <translation>Abrindo o projeto</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 aberto</translation>
    </message>
    <message>
        <source>Restoring the project</source>
        <translation>Restaurando o projeto</translation>
    </message>
    <message>
        <source>Restored unsaved changes of %1</source>
        <translation>Mudanças não salvas de %1 restauradas</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 salvo</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Abrir projeto</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Novo projeto</translation>
    </message>
    <message>
        <source>Restore project</source>
        <translation>Restaurar projeto</translation>
    </message>
    <message>
        <source>Unsaved changes would be lost in a crash, because the recovery copy cannot be written. Save often. %1</source>
        <translation>Alterações não salvas se perderiam em uma falha, pois a cópia de recuperação não pode ser gravada. Salve com frequência. %1</translation>
    </message>
    <message>
        <source>Saving the project</source>
        <translation>Salvando o projeto</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvar</translation>
    </message>
</context>
<context>
    <name>dipwright::DrawnPage</name>
    <message>
        <source>The page cannot be written: %1</source>
        <translation>A página não pode ser gravada: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::EditController</name>
    <message>
        <source>Replace model</source>
        <translation>Trocar modelo</translation>
    </message>
    <message>
        <source>Replace texture</source>
        <translation>Trocar textura</translation>
    </message>
</context>
<context>
    <name>dipwright::ExportController</name>
    <message>
        <source>Wrote the results to %1</source>
        <translation>Resultados gravados em %1</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 gravado</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>estiramento</translation>
    </message>
    <message>
        <source>Wrote the maps to %1</source>
        <translation>Mapas gravados em %1</translation>
    </message>
    <message>
        <source>Wrote the cradles to %1</source>
        <translation>Berços gravados em %1</translation>
    </message>
    <message>
        <source>Export results to a folder</source>
        <translation>Exportar resultados para uma pasta</translation>
    </message>
    <message>
        <source>Export results</source>
        <translation>Exportar resultados</translation>
    </message>
    <message>
        <source>Save sheet</source>
        <translation>Salvar folha</translation>
    </message>
    <message>
        <source>Export cradles</source>
        <translation>Exportar berços</translation>
    </message>
    <message>
        <source>Export cradles to a folder</source>
        <translation>Exportar berços para uma pasta</translation>
    </message>
    <message>
        <source>Export stretch</source>
        <translation>Exportar estiramento</translation>
    </message>
    <message>
        <source>These sheets were made before the last changes to the project. Run the dip again to print the current state.</source>
        <translation>Estas folhas foram feitas antes das últimas mudanças no projeto. Execute a imersão de novo para imprimir o estado atual.</translation>
    </message>
    <message>
        <source>Save maps</source>
        <translation>Salvar mapas</translation>
    </message>
    <message>
        <source>Save costs</source>
        <translation>Salvar custos</translation>
    </message>
    <message>
        <source>%1 costs</source>
        <translation>%1 custos</translation>
    </message>
    <message>
        <source>These sheets were made before the last changes to the project. Run the dip again to see the current state.</source>
        <translation>Estas folhas são anteriores às últimas mudanças no projeto. Rode a imersão de novo para ver o estado atual.</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmFit</name>
    <message>
        <source>Fitted</source>
        <translation>Ajustado</translation>
    </message>
    <message>
        <source>%1, dip %2</source>
        <translation>%1, imersão %2</translation>
    </message>
    <message>
        <source>measure it at the tank and leave it out of the fit</source>
        <translation>meça no tanque e deixe fora do ajuste</translation>
    </message>
    <message>
        <source>Swell along X</source>
        <translation>Inchamento ao longo de X</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxação</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Crescimento</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Distância de contato</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidade</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>The fit did not converge in %1 rounds; check for places that were mistaken for others, or fit fewer quantities</source>
        <translation>O ajuste não convergiu em %1 rodadas; verifique se há pontos confundidos com outros, ou ajuste menos grandezas</translation>
    </message>
    <message>
        <source>The pairs do not determine any quantity of the film; give more pairs, all round the part</source>
        <translation>Os pares não determinam nenhuma grandeza da película; dê mais pares, ao redor de toda a peça</translation>
    </message>
    <message>
        <source>None of the printed places lies on the part in the simulation; check that they belong to this job&apos;s sheet</source>
        <translation>Nenhum dos pontos impressos fica sobre a peça na simulação; verifique se eles são da folha deste trabalho</translation>
    </message>
    <message>
        <source>%1: %2 (before: %3; 95 % interval: %4)</source>
        <translation>%1: %2 (antes: %3; intervalo de 95 %: %4)</translation>
    </message>
    <message>
        <source>%1 and %2 cannot be determined independently: correlation %3</source>
        <translation>%1 e %2 não podem ser determinados de forma independente: correlação %3</translation>
    </message>
    <message>
        <source>%1 is not determined by these pairs and keeps its value</source>
        <translation>%1 não é determinado por estes pares e mantém seu valor</translation>
    </message>
    <message>
        <source>give pairs of places all round the part</source>
        <translation>dê pares de pontos ao redor de toda a peça</translation>
    </message>
    <message>
        <source>photograph places near the part&apos;s lowest point and others high on its sides, from more than one direction</source>
        <translation>fotografe pontos perto do ponto mais baixo da peça e outros no alto dos lados, de mais de uma direção</translation>
    </message>
    <message>
        <source>measure growth from photos of the floating film with “inspect film”</source>
        <translation>meça o crescimento em fotos da película flutuando com “inspect film”</translation>
    </message>
    <message>
        <source>The project&apos;s film does not grow, so its growth cannot be fitted; measure it from photos of the floating film with “inspect film”</source>
        <translation>A película do projeto não cresce, por isso seu crescimento não pode ser ajustado; meça-o em fotos da película flutuando com “inspect film”</translation>
    </message>
    <message>
        <source>%1 has no effect on this film and cannot be fitted</source>
        <translation>%1 não tem efeito sobre esta película e não pode ser ajustado</translation>
    </message>
    <message>
        <source>%1 moves none of the places, so the pairs do not determine it; %2</source>
        <translation>%1 não move nenhum dos pontos, por isso os pares não o determinam; %2</translation>
    </message>
    <message>
        <source>The pairs cannot separate %1 from the camera&apos;s position (correlation %2); %3</source>
        <translation>Os pares não separam %1 da posição da câmera (correlação %2); %3</translation>
    </message>
    <message>
        <source>give more pairs on the part itself, farther apart</source>
        <translation>dê mais pares na própria peça, mais afastados</translation>
    </message>
    <message>
        <source>give pairs on the part itself (edges, corners or holes) with --pairs</source>
        <translation>dê pares na própria peça (arestas, cantos ou furos) com --pairs</translation>
    </message>
    <message>
        <source>The pairs cannot separate %1 from %2 (correlation %3); fit only one of the two, or %4</source>
        <translation>Os pares não separam %1 de %2 (correlação %3); ajuste só um dos dois, ou %4</translation>
    </message>
    <message>
        <source>The pairs do not determine %1 well enough; give more pairs, or %2</source>
        <translation>Os pares não determinam %1 bem o bastante; dê mais pares, ou %2</translation>
    </message>
    <message>
        <source>“%1” cannot be fitted; choose from %2</source>
        <translation>“%1” não pode ser ajustado; escolha entre %2</translation>
    </message>
    <message>
        <source>A place belongs to dip %1, but the number of dips in the project is %2</source>
        <translation>Um ponto pertence à imersão %1, mas o número de imersões do projeto é %2</translation>
    </message>
    <message>
        <source>Position of the part along X</source>
        <translation>Posição da peça ao longo de X</translation>
    </message>
    <message>
        <source>Position of the part along Z</source>
        <translation>Posição da peça ao longo de Z</translation>
    </message>
    <message>
        <source>Rotation of the part about Y</source>
        <translation>Rotação da peça em torno de Y</translation>
    </message>
    <message>
        <source>Root mean square distance between the simulated and the photographed print: %1 px (%2 mm) before the fit, %3 px (%4 mm) after it</source>
        <translation>Valor quadrático médio da distância entre a impressão simulada e a fotografada: %1 px (%2 mm) antes do ajuste, %3 px (%4 mm) depois</translation>
    </message>
    <message>
        <source>%1 is uncertain by about %2 %: a change by 10 % moves none of the places by more than %3 mm; give more pairs, or %4</source>
        <translation>%1 tem uma incerteza de cerca de %2 %: uma mudança de 10 % não move nenhum dos pontos mais de %3 mm; dê mais pares, ou %4</translation>
    </message>
    <message>
        <source>There are too few pairs on the part to determine the %1 unknowns of film and camera; give more pairs, or fit fewer quantities</source>
        <translation>Há poucos pares na peça para determinar as %1 incógnitas de película e câmera; dê mais pares, ou ajuste menos grandezas</translation>
    </message>
    <message>
        <source>The fit found no film and camera that explain the pairs; check whether a pair names the wrong place</source>
        <translation>O ajuste não encontrou película e câmera que expliquem os pares; verifique se um par indica o lugar errado</translation>
    </message>
    <message>
        <source>Swell along Z</source>
        <translation>Inchamento ao longo de Z</translation>
    </message>
    <message>
        <source>The fit does not explain the places: their root mean square distance is %1 mm before the fit and %2 mm after it; check the coordinates of the sheet, and for places that were mistaken for others</source>
        <translation>O ajuste não explica os pontos: a distância média quadrática é de %1 mm antes e %2 mm depois; verifique as coordenadas da folha e se há pontos confundidos com outros</translation>
    </message>
    <message>
        <source>The film profile %1 has other values than the project&apos;s film, under which the values were fitted; compare the two before you use it</source>
        <translation>O perfil de película %1 tem valores diferentes dos da película do projeto com que foi feito o ajuste; compare os dois antes de usá-lo</translation>
    </message>
    <message>
        <source>The job&apos;s sheets are already corrected by its measured parts, so fitted values in the job would correct the same error twice; turn the correction off (As built) and fit a part whose sheet was not corrected</source>
        <translation>As folhas do trabalho já são corrigidas pelas peças medidas, então os valores ajustados corrigiriam o mesmo erro duas vezes; desative a correção (Como saiu) e ajuste uma peça cuja folha não foi corrigida</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmPage</name>
    <message>
        <source>Unevenness of the film</source>
        <translation>Irregularidade da película</translation>
    </message>
    <message>
        <source>Photos of the film</source>
        <translation>Fotos da película</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>não medida</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>Dip begins after</source>
        <translation>A imersão começa após</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>Lote</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remover</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Photos (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>Seconds since the film was laid on the water</source>
        <translation>Segundos desde que a película foi posta na água</translation>
    </message>
    <message>
        <source>Photo of the film</source>
        <translation>Foto da película</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Cantos</translation>
    </message>
    <message>
        <source>Unevenness</source>
        <translation>Irregularidade</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Distância focal</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Distorção</translation>
    </message>
    <message>
        <source>k1 ?</source>
        <translation>k1 ?</translation>
    </message>
    <message>
        <source>k2 ?</source>
        <translation>k2 ?</translation>
    </message>
    <message>
        <source>Corners found in the photo are shown here.</source>
        <translation>Os cantos encontrados na foto aparecem aqui.</translation>
    </message>
    <message>
        <source>Seconds on the water</source>
        <translation>Segundos na água</translation>
    </message>
    <message>
        <source>Seconds from laying the film on the water to the start of the dip. The swell is computed for this time.</source>
        <translation>Segundos desde pôr a película na água até o início da imersão. O inchamento é calculado para esse momento.</translation>
    </message>
    <message>
        <source>from the photos</source>
        <translation>das fotos</translation>
    </message>
    <message>
        <source>Rulers on the card</source>
        <translation>Réguas do cartão</translation>
    </message>
    <message>
        <source>Rulers on the dry film</source>
        <translation>Réguas da película seca</translation>
    </message>
    <message>
        <source>Reading error ±</source>
        <translation>Erro de leitura ±</translation>
    </message>
    <message>
        <source>Rulers and camera</source>
        <translation>Réguas e câmera</translation>
    </message>
    <message>
        <source>Readings of the printed rulers, height of the card, and camera data</source>
        <translation>Leituras das réguas impressas, altura do cartão e dados da câmera</translation>
    </message>
    <message>
        <source>Add &amp;photos…</source>
        <translation>Adicionar &amp;fotos…</translation>
    </message>
    <message>
        <source>&amp;Save to profile…</source>
        <translation>&amp;Salvar no perfil…</translation>
    </message>
    <message>
        <source>at the start of the dip</source>
        <translation>no início da imersão</translation>
    </message>
    <message>
        <source>%1: %2 corners on the film, %3 on the card, residual %4 px</source>
        <translation>%1: %2 cantos na película, %3 no cartão, resíduo de %4 px</translation>
    </message>
    <message>
        <source>Water temperature</source>
        <translation>Temperatura da água</translation>
    </message>
    <message>
        <source>Measured length of the horizontal ruler</source>
        <translation>Comprimento medido da régua horizontal</translation>
    </message>
    <message>
        <source>Measured length of the vertical ruler</source>
        <translation>Comprimento medido da régua vertical</translation>
    </message>
    <message>
        <source>Reading error of each ruler. A larger reading error gives a wider 95 % interval of the swell.</source>
        <translation>Erro de leitura de cada régua. Um erro de leitura maior dá um intervalo de 95 % mais largo do inchamento.</translation>
    </message>
    <message>
        <source>Focal length of the lens as 35 mm equivalent. Needed only if the card lies above the film.</source>
        <translation>Distância focal da lente equivalente a 35 mm. Necessária só se o cartão fica acima da película.</translation>
    </message>
    <message>
        <source>Coefficients of the lens distortion of a calibrated camera. “?”: the coefficient is found from each photo.</source>
        <translation>Coeficientes da distorção da lente de uma câmera calibrada. “?”: o coeficiente é determinado a partir de cada foto.</translation>
    </message>
    <message>
        <source>The places where the film has grown more or less than on average are shown here.</source>
        <translation>Os lugares onde a película cresceu mais ou menos que a média aparecem aqui.</translation>
    </message>
    <message>
        <source>Card height above film</source>
        <translation>Cartão acima da película</translation>
    </message>
    <message>
        <source>Print the two pages, then add photos of the film&apos;s chessboard on the water with the card beside it, or drop them here. The guide explains how to take them.</source>
        <translation>Imprima as duas páginas. Depois adicione fotos do xadrez da película na água com o cartão ao lado, ou solte-as aqui. O guia explica como fotografar.</translation>
    </message>
    <message>
        <source>Temperature of the water. It is kept with the measurement and does not change it.</source>
        <translation>Temperatura da água. É guardada com a medição e não a altera.</translation>
    </message>
    <message>
        <source>Number of the film&apos;s lot. It is kept with the measurement and printed on the pages.</source>
        <translation>Número do lote da película. É guardado com a medição e impresso nas páginas.</translation>
    </message>
    <message>
        <source>Pages to p&amp;rint…</source>
        <translation>Páginas para i&amp;mprimir…</translation>
    </message>
    <message>
        <source>Saves the chessboard for the film (film.pdf) and the card (card.pdf) to a folder. Print the film&apos;s page on the film and the card&apos;s page on stiff, waterproof cardboard, both at 100 %.</source>
        <translation>Salva o xadrez para a película (film.pdf) e o cartão (card.pdf) em uma pasta. Imprima a página da película na película e a do cartão em papel-cartão rígido e impermeável, ambas a 100 %.</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmProbe</name>
    <message>
        <source>on the water</source>
        <translation>na água</translation>
    </message>
    <message>
        <source>Part at %1, %2, %3</source>
        <translation>Peça em %1, %2, %3</translation>
    </message>
    <message>
        <source>on the part</source>
        <translation>na peça</translation>
    </message>
    <message>
        <source>Sheet at %1, %2 · %3 · stretch %4 and %5, area stretch %6</source>
        <translation>Folha em %1, %2 · %3 · estiramento %4 e %5, estiramento da área %6</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmWatch</name>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>Unevenness: 95 % of the film lies within %1 mm of where an evenly swollen film would lie</source>
        <translation>Irregularidade: 95 % da película ficam a no máximo %1 mm de onde estaria uma película inchada por igual</translation>
    </message>
    <message>
        <source>Unevenness of the film</source>
        <translation>Irregularidade da película</translation>
    </message>
    <message>
        <source>95 % of the corners lie within %1 mm of an evenly swollen film</source>
        <translation>95 % dos cantos ficam a no máximo %1 mm de uma película inchada por igual</translation>
    </message>
    <message>
        <source>The film&apos;s chessboard is mirrored; lay the film with its ink side up, and use the photo without flipping it</source>
        <translation>O tabuleiro da película está espelhado; ponha a película com o lado da tinta para cima e use a foto sem espelhá-la</translation>
    </message>
    <message>
        <source>The card is mirrored; use the photo without flipping it</source>
        <translation>O cartão está espelhado; use a foto sem espelhá-la</translation>
    </message>
    <message>
        <source>The photos show no measurable growth of the film</source>
        <translation>As fotos não mostram crescimento mensurável da película</translation>
    </message>
    <message>
        <source>Growth: %1 ± %2 % per second</source>
        <translation>Crescimento: %1 ± %2 % por segundo</translation>
    </message>
    <message>
        <source>Growth: %1 ± %2 % per second when the dip begins; %3 ± %4 % in total after a long time</source>
        <translation>Crescimento: %1 ± %2 % por segundo no início da imersão; %3 ± %4 % no total depois de muito tempo</translation>
    </message>
    <message>
        <source>The photo does not contain the camera&apos;s focal length, which is needed because the card lies above the film; give the 35 mm equivalent focal length</source>
        <translation>A foto não contém a distância focal da câmera, necessária porque o cartão fica acima da película; informe a distância focal equivalente a 35 mm</translation>
    </message>
    <message>
        <source>Too little of the film&apos;s chessboard is visible; photograph all of it, sharp and without glare</source>
        <translation>Vê-se muito pouco do tabuleiro da película; fotografe-o inteiro, nítido e sem reflexos</translation>
    </message>
    <message>
        <source>Only %1 corners of the film&apos;s chessboard are visible, but %2 are needed; photograph all of it, without glare</source>
        <translation>Só se veem %1 cantos do tabuleiro da película, mas são precisos %2; fotografe-o inteiro, sem reflexos</translation>
    </message>
    <message>
        <source>Only %1 corners of the card are visible, but %2 are needed; photograph all of it, without glare</source>
        <translation>Só se veem %1 cantos do cartão, mas são precisos %2; fotografe-o inteiro, sem reflexos</translation>
    </message>
    <message>
        <source>The swell was measured after %1 s, but the dip begins after %2 s; this swell does not include the growth in between</source>
        <translation>O inchamento foi medido após %1 s, mas a imersão começa após %2 s; esse inchamento não inclui o crescimento nesse intervalo</translation>
    </message>
    <message>
        <source>The photos show the film from %1 to %2 s after it was laid on the water, but the dip begins after %3 s; correct the times, or take photos both before and after the start of the dip</source>
        <translation>As fotos mostram a película de %1 a %2 s depois de posta na água, mas a imersão começa após %3 s; corrija os tempos, ou tire fotos antes e depois do início da imersão</translation>
    </message>
    <message>
        <source>Growth is not measured; to measure it, take photos at three or more times, from before the dip begins until after it ends</source>
        <translation>O crescimento não foi medido; para medi-lo, tire fotos em três ou mais momentos, de antes do início da imersão até depois do seu fim</translation>
    </message>
    <message>
        <source>The film still grew at the same rate in the last photo. Its growth limit is therefore unknown, and the growth in the profile stays unchanged. Take photos until the film stops growing</source>
        <translation>Na última foto a película ainda crescia na mesma taxa. Por isso o limite do crescimento é desconhecido, e o crescimento no perfil não muda. Fotografe até que a película pare de crescer</translation>
    </message>
    <message>
        <source>No chessboard for measuring the film is visible; print one with “dipwright-cli calibrate film” and photograph all of it, sharp and without glare</source>
        <translation>Não se vê nenhum tabuleiro para medir a película; imprima um com “dipwright-cli calibrate film” e fotografe-o inteiro, nítido e sem reflexos</translation>
    </message>
    <message>
        <source>The card that gives the scale is not visible; print it with “dipwright-cli calibrate card” and lay it beside the film</source>
        <translation>Não se vê o cartão que dá a escala; imprima-o com “dipwright-cli calibrate card” e ponha-o ao lado da película</translation>
    </message>
    <message>
        <source>The position of the film cannot be determined from the visible corners; photograph the whole film and the whole card from above</source>
        <translation>Os cantos visíveis não bastam para determinar a posição da película; fotografe de cima a película inteira e o cartão inteiro</translation>
    </message>
    <message>
        <source>The card&apos;s corners lie %1 px from their places on a flat card; lay the card flat, and correct or clear the values for lens distortion, focal length and card height</source>
        <translation>Os cantos do cartão estão a %1 px de seus lugares num cartão plano; deite o cartão plano, e corrija ou apague os valores da distorção da lente, da distância focal e da altura do cartão</translation>
    </message>
    <message>
        <source>Swell when the dip begins: along X %1, along Z %2</source>
        <translation>Inchamento no início da imersão: ao longo de X %1, ao longo de Z %2</translation>
    </message>
    <message>
        <source>In these photos the film shrinks by %1 % per second, but film grows on the water; check that the times are in the order of the photos</source>
        <translation>Nestas fotos a película encolhe %1 % por segundo, mas na água a película cresce; verifique se os tempos estão na ordem das fotos</translation>
    </message>
    <message>
        <source>The sizes of the film in these photos do not determine its growth; check that the times are in the order of the photos, and take photos from before the dip begins until the film stops growing</source>
        <translation>Os tamanhos da película nestas fotos não determinam o crescimento; verifique se os tempos estão na ordem das fotos, e tire fotos de antes do início da imersão até a película parar de crescer</translation>
    </message>
    <message>
        <source>The photo is the same as %1; give each photo only once</source>
        <translation>A foto é igual a %1; indique cada foto só uma vez</translation>
    </message>
    <message>
        <source>Colour: growth relative to the mean swell %1 · arrows: displacement, scale %2:1</source>
        <translation>Cor: crescimento em relação ao inchamento médio %1 · setas: deslocamento, escala %2:1</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmWatchController</name>
    <message>
        <source>Reading photos</source>
        <translation>Lendo fotos</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Measuring the film</source>
        <translation>Medindo a película</translation>
    </message>
    <message>
        <source>The project refers to these photos:</source>
        <translation>O projeto se refere a estas fotos:</translation>
    </message>
    <message>
        <source>Film on the water</source>
        <translation>Película na água</translation>
    </message>
    <message>
        <source>The photo %1 has changed since it was added.</source>
        <translation>A foto %1 mudou desde que foi adicionada.</translation>
    </message>
    <message>
        <source>Export film measurement to a folder</source>
        <translation>Exportar medição da película para uma pasta</translation>
    </message>
    <message>
        <source>Export film measurement</source>
        <translation>Exportar medição da película</translation>
    </message>
    <message>
        <source>Wrote the film measurement to %1</source>
        <translation>Medição da película gravada em %1</translation>
    </message>
    <message>
        <source>Save the pages for the film and the card to a folder</source>
        <translation>Salvar as páginas da película e do cartão em uma pasta</translation>
    </message>
    <message>
        <source>Save pages to print</source>
        <translation>Salvar páginas para imprimir</translation>
    </message>
    <message>
        <source>Wrote film.pdf and card.pdf to %1. Print them at 100 %; the rulers must measure 100 mm.</source>
        <translation>film.pdf e card.pdf foram salvos em %1. Imprima-os a 100 %; as réguas devem medir 100 mm.</translation>
    </message>
</context>
<context>
    <name>dipwright::FinishedPartPreview</name>
    <message>
        <source>Computing the finished part</source>
        <translation>Calculando a peça pronta</translation>
    </message>
</context>
<context>
    <name>dipwright::FitController</name>
    <message>
        <source>Fitting film and dip</source>
        <translation>Ajustando película e imersão</translation>
    </message>
    <message>
        <source>Wrote the fit to %1</source>
        <translation>Ajuste gravado em %1</translation>
    </message>
    <message>
        <source>Use in project</source>
        <translation>Usar no projeto</translation>
    </message>
    <message>
        <source>Export fit to a folder</source>
        <translation>Exportar ajuste para uma pasta</translation>
    </message>
    <message>
        <source>Export fit</source>
        <translation>Exportar ajuste</translation>
    </message>
</context>
<context>
    <name>dipwright::FitPage</name>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Correlação</translation>
    </message>
    <message>
        <source>Fitted quantities</source>
        <translation>Grandezas ajustadas</translation>
    </message>
    <message>
        <source>Correlations of the fitted quantities</source>
        <translation>Correlações das grandezas ajustadas</translation>
    </message>
    <message>
        <source>&amp;Fit film and dip</source>
        <translation>&amp;Ajustar película e imersão</translation>
    </message>
    <message>
        <source>&amp;Use in project</source>
        <translation>&amp;Usar no projeto</translation>
    </message>
    <message>
        <source>Puts the fitted film, placement and depth into the project. The film then counts as measured.</source>
        <translation>Põe película, posição e profundidade ajustadas no projeto. A película passa a contar como medida.</translation>
    </message>
    <message>
        <source>&amp;Save to profile…</source>
        <translation>&amp;Salvar no perfil…</translation>
    </message>
    <message>
        <source>The project uses the film, placement and depth of this fit. To fit again, find the corners again.</source>
        <translation>O projeto usa a película, a posição e a profundidade deste ajuste. Para ajustar outra vez, procure os cantos de novo.</translation>
    </message>
    <message>
        <source>First find the corners on the page “Dipped part”. Film and dip are fitted to them.</source>
        <translation>Procure primeiro os cantos na página “Peça mergulhada”. Película e imersão são ajustadas a eles.</translation>
    </message>
    <message>
        <source>Fits placement, swell and relaxation, as far as the photos determine them.</source>
        <translation>Ajusta posição, inchamento e relaxação, até onde as fotos os determinam.</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>Ajustado</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Intervalo de 95 %</translation>
    </message>
    <message>
        <source>Near 1 or −1: the photos determine only a combination of the two quantities, not each quantity separately</source>
        <translation>Perto de 1 ou −1: as fotos determinam só uma combinação das duas grandezas, não cada uma separadamente</translation>
    </message>
    <message>
        <source>Changes the settings of film and dip and repeats the simulation until the simulated image lies where the photos show it</source>
        <translation>Muda as configurações da película e da imersão e repete a simulação até a imagem simulada ficar onde as fotos a mostram</translation>
    </message>
    <message>
        <source>No pair is a place on the part itself, such as a corner or a hole. Without such pairs, a shift or rotation of the whole image looks the same as a movement of the camera.</source>
        <translation>Nenhum par é um lugar da própria peça, como um canto ou um furo. Sem esses pares, um deslocamento ou giro de toda a imagem parece igual a um movimento da câmera.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
</context>
<context>
    <name>dipwright::GuidePictures</name>
    <message>
        <source>film.pdf
printed on the film</source>
        <translation>film.pdf
impresso na película</translation>
    </message>
    <message>
        <source>card.pdf
printed on stiff, waterproof cardboard</source>
        <translation>card.pdf
impresso em papel-cartão rígido e impermeável</translation>
    </message>
    <message>
        <source>The card beside it, flat</source>
        <translation>O cartão ao lado, plano</translation>
    </message>
    <message>
        <source>From above, both whole, no glare</source>
        <translation>De cima, os dois inteiros, sem reflexo</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>The rulers on both must measure 100 mm</source>
        <translation>As réguas dos dois devem medir 100 mm</translation>
    </message>
    <message>
        <source>The film, ink side up, as for a dip</source>
        <translation>A película, tinta para cima, como na imersão</translation>
    </message>
    <message>
        <source>Both at the same height: the card gives the scale</source>
        <translation>Ambos à mesma altura: o cartão dá a escala</translation>
    </message>
    <message>
        <source>Note the time when you lay the film</source>
        <translation>Anote a hora em que põe a película</translation>
    </message>
    <message>
        <source>One photo gives the swell, three or more give the growth</source>
        <translation>Uma foto dá o inchamento; três ou mais, o crescimento</translation>
    </message>
    <message>
        <source>Take photos before the dip and until the film stops growing</source>
        <translation>Tire fotos antes da imersão e até a película parar de crescer</translation>
    </message>
</context>
<context>
    <name>dipwright::GuideWindow</name>
    <message>
        <source>Contents</source>
        <translation>Conteúdo</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Buscar no guia</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Guia do usuário</translation>
    </message>
    <message>
        <source>Press Enter to go to the next match</source>
        <translation>Enter vai à próxima ocorrência</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Nenhuma ocorrência</translation>
    </message>
    <message>
        <source>Matches: %1</source>
        <translation>Ocorrências: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::HelpController</name>
    <message>
        <source>Welcome</source>
        <translation>Bem-vindo</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>O projeto</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>A vista</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Executar</translation>
    </message>
    <message>
        <source>The timeline</source>
        <translation>A linha do tempo</translation>
    </message>
    <message>
        <source>The results</source>
        <translation>Os resultados</translation>
    </message>
    <message>
        <source>About Dipwright</source>
        <translation>Sobre o Dipwright</translation>
    </message>
    <message>
        <source>Computational hydrographic printing.</source>
        <translation>Impressão hidrográfica computacional.</translation>
    </message>
    <message>
        <source>Dipwright computes the image to print on a film. When the part is dipped through the film, every colour lands in its intended place.</source>
        <translation>O Dipwright calcula a imagem a imprimir em uma película. Quando a peça é mergulhada através da película, cada cor cai no lugar previsto.</translation>
    </message>
    <message>
        <source>Model, film, one or two dips, sheet and ink. Select an entry in the tree and change its values below. To begin, drop a model on the window.</source>
        <translation>Modelo, película, uma ou duas imersões, folha e tinta. Escolha um item na árvore e mude seus valores abaixo. Para começar, solte um modelo na janela.</translation>
    </message>
    <message>
        <source>The part above the film. Drag to look at it from all sides, turn it with the rings, then press Run.</source>
        <translation>A peça acima da película. Arraste para vê-la de todos os lados, gire-a com os anéis e aperte Executar.</translation>
    </message>
    <message>
        <source>Simulates the dip while you watch. You can cancel at any time. With “Run live”, each change recomputes the results that depend on it.</source>
        <translation>Simula a imersão diante de você. Você pode cancelar a qualquer momento. Com “Executar ao vivo”, cada mudança recalcula os resultados que dependem dela.</translation>
    </message>
    <message>
        <source>Replays the dip or shows any moment of it.</source>
        <translation>Reproduz a imersão de novo ou mostra qualquer momento dela.</translation>
    </message>
    <message>
        <source>The stretch of the film, the image on it, the finished part and the sheet to print. Move the cursor over one picture to see the same place in the others.</source>
        <translation>O estiramento da película, a imagem nela, a peça pronta e a folha a imprimir. Passe o cursor sobre uma imagem para ver o mesmo lugar nas outras.</translation>
    </message>
    <message>
        <source>The report was copied to the clipboard</source>
        <translation>O relatório foi copiado para a área de transferência</translation>
    </message>
</context>
<context>
    <name>dipwright::Histogram</name>
    <message>
        <source>Histogram</source>
        <translation>Histograma</translation>
    </message>
</context>
<context>
    <name>dipwright::ImportModel</name>
    <message>
        <source>Entities of the CAD file that cannot be read, so that faces or parts may be missing: %1</source>
        <translation>Entidades do arquivo CAD que não podem ser lidas, de modo que podem faltar faces ou peças: %1</translation>
    </message>
    <message>
        <source>it is incomplete or damaged</source>
        <translation>ele está incompleto ou danificado</translation>
    </message>
    <message>
        <source>The model&apos;s blend shapes are not applied, so it has its shape without them; apply them in a modelling program</source>
        <translation>As blend shapes do modelo não são aplicadas, por isso ele fica com a forma sem elas; aplique-as em um programa de modelagem</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Lendo o modelo</translation>
    </message>
    <message>
        <source>The model&apos;s size must be more than 0 and at most %1 mm</source>
        <translation>O tamanho do modelo deve ser maior que 0 e no máximo %1 mm</translation>
    </message>
    <message>
        <source>The model&apos;s unit must be a positive number of millimetres</source>
        <translation>A unidade do modelo deve ser um número positivo de milímetros</translation>
    </message>
    <message>
        <source>The model file does not exist; check its name</source>
        <translation>O arquivo do modelo não existe; confira o nome</translation>
    </message>
    <message>
        <source>This is a folder; choose a model file in it</source>
        <translation>Isto é uma pasta; escolha um arquivo de modelo nela</translation>
    </message>
    <message>
        <source>The model file cannot be read; check its permissions</source>
        <translation>O arquivo do modelo não pode ser lido; confira as permissões</translation>
    </message>
    <message>
        <source>None of the model&apos;s triangles has an area; choose another model</source>
        <translation>Nenhum triângulo do modelo tem área; escolha outro modelo</translation>
    </message>
    <message>
        <source>The file %1, which the model names, was not found</source>
        <translation>O arquivo %1, citado pelo modelo, não foi encontrado</translation>
    </message>
    <message>
        <source>The model has no triangles; save it with its surface</source>
        <translation>O modelo não tem triângulos; salve-o com a superfície</translation>
    </message>
    <message>
        <source>Checking the model</source>
        <translation>Verificando o modelo</translation>
    </message>
    <message>
        <source>Finding the texture&apos;s charts</source>
        <translation>Localizando as ilhas da textura</translation>
    </message>
    <message>
        <source>The texture %1 was not found beside the model; its material&apos;s colour is used instead</source>
        <translation>A textura %1 não foi encontrada ao lado do modelo; usa-se a cor do material</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>termina cedo demais</translation>
    </message>
    <message>
        <source>there is a word where a number should be</source>
        <translation>há uma palavra onde deveria haver um número</translation>
    </message>
    <message>
        <source>it is not a PLY file</source>
        <translation>não é um arquivo PLY</translation>
    </message>
    <message>
        <source>its PLY format %1 is unknown</source>
        <translation>seu formato PLY %1 é desconhecido</translation>
    </message>
    <message>
        <source>its header is not understood</source>
        <translation>seu cabeçalho não é compreendido</translation>
    </message>
    <message>
        <source>its points have no x, y and z</source>
        <translation>seus pontos não têm x, y e z</translation>
    </message>
    <message>
        <source>its faces have no corners</source>
        <translation>suas faces não têm vértices</translation>
    </message>
    <message>
        <source>texture %1 in %2</source>
        <translation>textura %1 em %2</translation>
    </message>
    <message>
        <source>Reading triangles</source>
        <translation>Lendo triângulos</translation>
    </message>
    <message>
        <source>it is not a 3MF package</source>
        <translation>não é um pacote 3MF</translation>
    </message>
    <message>
        <source>its elements are out of order</source>
        <translation>seus elementos estão fora de ordem</translation>
    </message>
    <message>
        <source>there is no number where one should be</source>
        <translation>falta um número onde deveria haver</translation>
    </message>
    <message>
        <source>The texture %1 is not in the model&apos;s package; its material&apos;s colour is used instead</source>
        <translation>A textura %1 não está no pacote do modelo; usa-se a cor do material</translation>
    </message>
    <message>
        <source>The model has no texture coordinates, so no picture can be placed on it; unwrap it in a modelling program first</source>
        <translation>O modelo não tem coordenadas de textura, portanto nenhuma imagem pode ser posta nele; planifique-o antes em um programa de modelagem</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>o arquivo não pode ser aberto</translation>
    </message>
    <message>
        <source>Triangles without area that were removed: %1</source>
        <translation>Triângulos sem área que foram removidos: %1</translation>
    </message>
    <message>
        <source>its unit %1 is unknown</source>
        <translation>sua unidade %1 é desconhecida</translation>
    </message>
    <message>
        <source>its format is not supported</source>
        <translation>seu formato não é suportado</translation>
    </message>
    <message>
        <source>line %1 declares more values than the file can hold</source>
        <translation>a linha %1 declara mais valores do que o arquivo pode conter</translation>
    </message>
    <message>
        <source>line %1 has no number where one is expected</source>
        <translation>na linha %1 falta um número</translation>
    </message>
    <message>
        <source>its array %1 has fewer values than an accessor reads</source>
        <translation>sua lista %1 tem menos valores do que um accessor lê</translation>
    </message>
    <message>
        <source>it needs the glTF extension %1, which is not supported (export it without that extension)</source>
        <translation>ele precisa da extensão glTF %1, que não é suportada (exporte-o sem essa extensão)</translation>
    </message>
    <message>
        <source>its points or texture coordinates are stored as integers, which is not supported (export it with float coordinates, without quantization)</source>
        <translation>seus pontos ou coordenadas de textura estão gravados como números inteiros, o que não é suportado (exporte-o com coordenadas de ponto flutuante, sem quantização)</translation>
    </message>
    <message>
        <source>The model scales or rotates a texture (KHR_texture_transform), which is not shown correctly; apply the transform to the texture coordinates in a modelling program</source>
        <translation>O modelo redimensiona ou gira uma textura (KHR_texture_transform), o que não é mostrado corretamente; aplique a transformação às coordenadas de textura em um programa de modelagem</translation>
    </message>
    <message>
        <source>A texture of the model has no picture or is in an unsupported format, so its material&apos;s colour is used instead; export the texture as PNG or JPEG</source>
        <translation>Uma textura do modelo não tem imagem ou está em um formato não suportado, então a cor do seu material é usada no lugar; exporte a textura como PNG ou JPEG</translation>
    </message>
    <message>
        <source>%1 sets material properties before its first material</source>
        <translation>%1 define propriedades de material antes do seu primeiro material</translation>
    </message>
    <message>
        <source>Some texture options in %1 are ignored: %2; apply them to the picture in a modelling program</source>
        <translation>Algumas opções de textura em %1 são ignoradas: %2; aplique-as à imagem em um programa de modelagem</translation>
    </message>
    <message>
        <source>it holds more data than its header declares</source>
        <translation>contém mais dados do que seu cabeçalho declara</translation>
    </message>
    <message>
        <source>a face refers to a point that does not exist</source>
        <translation>uma face se refere a um ponto que não existe</translation>
    </message>
    <message>
        <source>The model&apos;s vertex colours are not used; bake them into a texture to print them</source>
        <translation>As cores dos vértices do modelo não são usadas; grave-as em uma textura para imprimi-las</translation>
    </message>
    <message>
        <source>a triangle refers to a point that does not exist</source>
        <translation>um triângulo se refere a um ponto que não existe</translation>
    </message>
    <message>
        <source>it needs the 3MF extension %1, which is not supported</source>
        <translation>precisa da extensão 3MF %1, que não é suportada</translation>
    </message>
    <message>
        <source>two of its resources have the ID %1</source>
        <translation>dois dos seus recursos têm o ID %1</translation>
    </message>
    <message>
        <source>it refers to a material or texture that does not exist</source>
        <translation>se refere a um material ou uma textura que não existe</translation>
    </message>
    <message>
        <source>one of its transforms does not have twelve numbers</source>
        <translation>uma das suas transformações não tem doze números</translation>
    </message>
    <message>
        <source>the file %1 is missing from the package</source>
        <translation>o arquivo %1 falta no pacote</translation>
    </message>
    <message>
        <source>it places an object that does not exist</source>
        <translation>posiciona um objeto que não existe</translation>
    </message>
    <message>
        <source>All points of the model coincide; choose another model</source>
        <translation>Todos os pontos do modelo coincidem; escolha outro modelo</translation>
    </message>
    <message>
        <source>The model has no texture coordinates, so its texture cannot be placed; the colours of its materials are used instead</source>
        <translation>O modelo não tem coordenadas de textura, então a textura não pode ser aplicada; as cores dos materiais são usadas no lugar</translation>
    </message>
    <message>
        <source>The model needs more memory than this computer has; simplify the model</source>
        <translation>O modelo precisa de mais memória do que este computador tem; simplifique o modelo</translation>
    </message>
    <message>
        <source>Duplicate triangles that were removed: %1</source>
        <translation>Triângulos duplicados que foram removidos: %1</translation>
    </message>
    <message>
        <source>Triangles flipped to face the same way as their neighbours: %1</source>
        <translation>Triângulos virados porque estavam ao contrário dos vizinhos: %1</translation>
    </message>
    <message>
        <source>the length of a list is not a whole number</source>
        <translation>o comprimento de uma lista não é um número inteiro</translation>
    </message>
    <message>
        <source>the file %1 in the package is encrypted</source>
        <translation>o arquivo %1 no pacote está criptografado</translation>
    </message>
    <message>
        <source>the file %1 in the package is damaged</source>
        <translation>o arquivo %1 no pacote está danificado</translation>
    </message>
    <message>
        <source>the file %1 in the package has an error: %2</source>
        <translation>o arquivo %1 no pacote tem um erro: %2</translation>
    </message>
    <message>
        <source>The model&apos;s largest dimension would be %1 mm; set the size that it should have</source>
        <translation>A maior dimensão do modelo seria de %1 mm; informe o tamanho desejado</translation>
    </message>
    <message>
        <source>The mesh is not closed, so the program can only estimate which points lie inside it; if the result looks wrong, close the mesh</source>
        <translation>A malha não é fechada, por isso o programa só pode estimar quais pontos estão dentro dela; se o resultado parecer errado, feche a malha</translation>
    </message>
    <message>
        <source>The model&apos;s largest dimension is only %1 mm; if its file is not in millimetres, set the size that it should have</source>
        <translation>A maior dimensão do modelo é de só %1 mm; se o arquivo não estiver em milímetros, informe o tamanho desejado</translation>
    </message>
    <message>
        <source>The model was not read, because it names files that are hidden or outside its folder, such as %1; put these files beside the model, or allow them (--allow-outside)</source>
        <translation>O modelo não foi lido, porque cita arquivos ocultos ou fora da sua pasta, como %1; coloque esses arquivos ao lado do modelo ou permita-os (--allow-outside)</translation>
    </message>
    <message>
        <source>Points merged where rounded coordinates had left a gap: %1</source>
        <translation>Pontos unidos onde coordenadas arredondadas tinham deixado uma fenda: %1</translation>
    </message>
    <message>
        <source>Pieces of the surface flipped because they were inside out: %1</source>
        <translation>Pedaços da superfície virados porque estavam do avesso: %1</translation>
    </message>
    <message>
        <source>The model cannot be read: %1; save it again, or as %2</source>
        <translation>O modelo não pode ser lido: %1; salve-o de novo ou como %2</translation>
    </message>
    <message>
        <source>The model file is empty; save it again</source>
        <translation>O arquivo do modelo está vazio; salve-o de novo</translation>
    </message>
    <message>
        <source>%1 corners of the model&apos;s triangles are not numbers (NaN or infinite); repair the model and save it again</source>
        <translation>%1 vértices dos triângulos do modelo não são números (NaN ou infinito); repare o modelo e salve-o de novo</translation>
    </message>
    <message>
        <source>The model lies too far from its origin; move it to the origin and save it again</source>
        <translation>O modelo está longe demais da origem; mova-o para a origem e salve-o de novo</translation>
    </message>
    <message>
        <source>it has no surfaces</source>
        <translation>ele não tem superfícies</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>ele está danificado</translation>
    </message>
    <message>
        <source>it has no geometry</source>
        <translation>ele não tem geometria</translation>
    </message>
    <message>
        <source>IGES cannot be read on Windows</source>
        <translation>IGES não pode ser lido no Windows</translation>
    </message>
    <message>
        <source>The CAD file cannot be read: %1; save it again as STEP (AP214 or AP242) in the CAD program</source>
        <translation>O arquivo CAD não pode ser lido: %1; salve-o de novo como STEP (AP214 ou AP242) no programa CAD</translation>
    </message>
    <message>
        <source>it is neither STEP nor IGES</source>
        <translation>ele não é STEP nem IGES</translation>
    </message>
    <message>
        <source>Reading the CAD file</source>
        <translation>Lendo o arquivo CAD</translation>
    </message>
    <message>
        <source>its geometry is invalid (%1)</source>
        <translation>sua geometria é inválida (%1)</translation>
    </message>
    <message>
        <source>Cutting the surfaces into triangles</source>
        <translation>Dividindo as superfícies em triângulos</translation>
    </message>
    <message>
        <source>Faces that are missing, because they cannot be cut into triangles: %1 (%2)</source>
        <translation>Faces que faltam, porque não podem ser divididas em triângulos: %1 (%2)</translation>
    </message>
    <message>
        <source>its surfaces have no extent</source>
        <translation>suas superfícies não têm extensão</translation>
    </message>
    <message>
        <source>its surfaces cannot be cut into triangles</source>
        <translation>suas superfícies não podem ser divididas em triângulos</translation>
    </message>
    <message>
        <source>The model mirrors a texture past its edge, or ends it there; here it repeats, so these places are wrong. Apply this to the picture in a modelling program</source>
        <translation>O modelo espelha uma textura além da borda ou a termina ali; aqui ela se repete, e esses lugares ficam errados. Aplique isso à imagem num programa de modelagem</translation>
    </message>
    <message>
        <source>The model tints a texture with its material&apos;s colour, which is not shown; apply the colour to the picture</source>
        <translation>O modelo tinge uma textura com a cor do material, o que não é mostrado; aplique a cor à imagem</translation>
    </message>
    <message>
        <source>The model has several sets of texture coordinates, and its file does not say clearly which set its texture uses; if the texture is misplaced, delete the other sets in a modelling program</source>
        <translation>O modelo tem vários conjuntos de coordenadas de textura, e o arquivo não diz claramente qual conjunto a textura usa; se a textura estiver fora do lugar, exclua os outros conjuntos em um programa de modelagem</translation>
    </message>
    <message>
        <source>The model moves, scales or rotates a texture, which is not shown correctly; apply the transform to the texture coordinates in a modelling program</source>
        <translation>O modelo move, redimensiona ou gira uma textura, o que não é mostrado corretamente; aplique a transformação às coordenadas de textura em um programa de modelagem</translation>
    </message>
    <message>
        <source>a skin lacks bind matrices for some of its joints</source>
        <translation>um skin não tem matrizes de ligação para algumas de suas articulações</translation>
    </message>
    <message>
        <source>The skin of the model does not say clearly how joints move %1 of its points, so these stay as stored; apply the armature in a modelling program</source>
        <translation>O skin do modelo não diz claramente como as articulações movem %1 de seus pontos, então estes ficam como estão gravados; aplique o esqueleto em um programa de modelagem</translation>
    </message>
    <message>
        <source>its GlobalSettings name impossible axes or units</source>
        <translation>suas GlobalSettings indicam eixos ou unidades impossíveis</translation>
    </message>
    <message>
        <source>a node uses a skin that does not exist</source>
        <translation>um nó usa um skin que não existe</translation>
    </message>
    <message>
        <source>The file has a master scale of %1, which programs apply in different ways, so it is not applied; check the size of the model</source>
        <translation>O arquivo tem uma escala mestra (master scale) de %1, que os programas aplicam de maneiras diferentes; por isso ela não é aplicada; verifique o tamanho do modelo</translation>
    </message>
    <message>
        <source>Objects that their matrix mirrors: %1, first %2. Programs read these in different ways, so they may be mirrored wrongly; apply their transforms in a modelling program</source>
        <translation>Objetos que a própria matriz espelha: %1, o primeiro é %2. Os programas leem esses objetos de maneiras diferentes, por isso eles podem estar espelhados de forma errada; aplique as transformações deles em um programa de modelagem</translation>
    </message>
    <message>
        <source>The sizes of the file&apos;s parts do not fit together, so its scale and its mirrored objects are not known; export the model again</source>
        <translation>Os tamanhos das partes do arquivo não combinam; por isso não se conhecem sua escala nem seus objetos espelhados; exporte o modelo novamente</translation>
    </message>
    <message>
        <source>The model has a transparent material without a texture, which is shown opaque; give the material a texture with transparency</source>
        <translation>O modelo tem um material transparente sem textura, que é mostrado opaco; dê ao material uma textura com transparência</translation>
    </message>
    <message>
        <source>The model mixes colours within its triangles, or mixes materials (3MF compositematerials or multiproperties), which is not shown; bake its colours into a texture to print them</source>
        <translation>O modelo mistura cores dentro dos seus triângulos, ou mistura materiais (compositematerials ou multiproperties do 3MF), o que não é mostrado; grave suas cores em uma textura para imprimi-las</translation>
    </message>
    <message>
        <source>The model&apos;s coordinates are too large; scale the model down in a modelling program and save it again</source>
        <translation>As coordenadas do modelo são grandes demais; reduza o modelo em um programa de modelagem e salve-o de novo</translation>
    </message>
    <message>
        <source>The texture coordinates of %1 triangles are not numbers or are too large; these triangles show their material&apos;s colour</source>
        <translation>As coordenadas de textura de %1 triângulos não são números ou são grandes demais; esses triângulos mostram a cor do seu material</translation>
    </message>
    <message>
        <source>The model has a texture of several layers, which is not shown correctly; merge the layers into one picture</source>
        <translation>O modelo tem uma textura de várias camadas, que não é mostrada corretamente; junte as camadas em uma só imagem</translation>
    </message>
    <message>
        <source>Objects that share the mesh of another object, but not its materials: %1, first %2. They are shown with the materials of that object; give each object its own mesh in a modelling program</source>
        <translation>Objetos que compartilham a malha de outro objeto, mas não seus materiais: %1, primeiro %2. São mostrados com os materiais daquele objeto; dê a cada objeto sua própria malha em um programa de modelagem</translation>
    </message>
    <message>
        <source>Objects that do not inherit the scale of their parents as usual (InheritType): %1, first %2. This is not followed, so they may have another size or shape; apply their transforms in a modelling program</source>
        <translation>Objetos que não herdam a escala de seus pais como de costume (InheritType): %1, primeiro %2. Isso não é seguido, portanto podem ter outro tamanho ou forma; aplique suas transformações em um programa de modelagem</translation>
    </message>
    <message>
        <source>Hidden objects: %1, first %2. They are imported, too, and dipped with the others; delete them in a modelling program if they do not belong to the part</source>
        <translation>Objetos ocultos: %1, primeiro %2. Também são importados e mergulhados com os outros; apague-os em um programa de modelagem se não pertencerem à peça</translation>
    </message>
    <message>
        <source>The model wants hard edges between the pixels of a picture (magFilter NEAREST), but the sheet shows smooth changes of colour; enlarge the picture without smoothing in an image program</source>
        <translation>O modelo pede bordas nítidas entre os pixels de uma imagem (magFilter NEAREST), mas a folha mostra transições suaves de cor; amplie a imagem sem suavização em um programa de imagens</translation>
    </message>
    <message>
        <source>its line %1 gives a point by %2 numbers instead of 3</source>
        <translation>sua linha %1 define um ponto com %2 números em vez de 3</translation>
    </message>
    <message>
        <source>its line %1 gives a point the weight %2, which programs read in different ways</source>
        <translation>sua linha %1 dá a um ponto o peso %2, que os programas leem de formas diferentes</translation>
    </message>
    <message>
        <source>Faces whose edges cross each other: %1. Their inside is not clear, so they may be filled wrongly; cut them into triangles in a modelling program</source>
        <translation>Faces cujas arestas se cruzam: %1. Seu interior não é claro, portanto podem estar preenchidas de forma errada; divida-as em triângulos em um programa de modelagem</translation>
    </message>
    <message>
        <source>Some points of the model (%1) lie more than %2 times as far from its middle as most points; delete them in a modelling program and save the model again</source>
        <translation>Alguns pontos do modelo (%1) estão mais de %2 vezes mais longe do centro do que a maioria; apague-os em um programa de modelagem e salve o modelo de novo</translation>
    </message>
    <message>
        <source>line %1 has fans of triangles, which are not supported (export the model as triangles)</source>
        <translation>a linha %1 tem leques de triângulos, que não são aceitos (exporte o modelo como triângulos)</translation>
    </message>
    <message>
        <source>line %1 skews a node, which is not supported (apply the transforms in a modelling program)</source>
        <translation>a linha %1 inclina um nó, o que não é aceito (aplique as transformações em um programa de modelagem)</translation>
    </message>
    <message>
        <source>line %1 turns a node about an axis whose length is not 1, so it would change the shape (apply the transforms in a modelling program)</source>
        <translation>a linha %1 gira um nó em torno de um eixo cujo comprimento não é 1, e assim mudaria a forma (aplique as transformações em um programa de modelagem)</translation>
    </message>
    <message>
        <source>the rotation of a node is not a quaternion of length 1, so it would change the size (export the model again)</source>
        <translation>a rotação de um nó não é um quatérnio de comprimento 1, e assim mudaria o tamanho (exporte o modelo de novo)</translation>
    </message>
    <message>
        <source>Some triangles (%1) have no place on the model&apos;s texture; they show one colour, which is mixed from its corners</source>
        <translation>Alguns triângulos (%1) não têm lugar na textura do modelo; eles mostram uma única cor, misturada dos cantos dela</translation>
    </message>
    <message>
        <source>the image in line %1 has no file name (Collada 1.4 has it directly in init_from)</source>
        <translation>a imagem na linha %1 não tem nome de arquivo (no Collada 1.4 ele fica diretamente em init_from)</translation>
    </message>
    <message>
        <source>The model has a material with a picture of its light (emission), but none of its colour, and the picture is not shown; use it for the colour in a modelling program</source>
        <translation>O modelo tem um material com uma imagem da sua luz (emissão), mas nenhuma da sua cor, e a imagem não é mostrada; use-a para a cor em um programa de modelagem</translation>
    </message>
    <message>
        <source>The model has triangles that were painted in a slicer, whose paint is not shown; paint the model in a modelling program, with a texture</source>
        <translation>O modelo tem triângulos pintados em um fatiador, cuja pintura não é mostrada; pinte o modelo em um programa de modelagem, com uma textura</translation>
    </message>
    <message>
        <source>Triangles inside the body that were removed: %1</source>
        <translation>Triângulos no interior do corpo que foram removidos: %1</translation>
    </message>
    <message>
        <source>the number of polygons before line %1 differs from the declared count</source>
        <translation>o número de polígonos antes da linha %1 difere do declarado</translation>
    </message>
    <message>
        <source>Faces of different colours or textures overlap in one plane, on about %1 mm², and either may be printed there; in a modelling program, delete the faces that should not show, or move one body by 0.1 mm</source>
        <translation>Faces com cores ou texturas diferentes se sobrepõem em um plano, em cerca de %1 mm², e qualquer uma delas pode ser impressa ali; em um programa de modelagem, exclua as faces que não devem aparecer ou mova um corpo em 0,1 mm</translation>
    </message>
    <message>
        <source>The picture cannot be read; check its name and permissions</source>
        <translation>A imagem não pode ser lida; confira o nome e as permissões</translation>
    </message>
</context>
<context>
    <name>dipwright::InkLaw</name>
    <message>
        <source>“%1” is not an ink tone; write ink, density, exponent, bend and greatest stretch, such as cyan 0.3 0.48 0.1 2.9</source>
        <translation>“%1” não é um tom de tinta; escreva tinta, densidade, expoente, curvatura e maior estiramento, como cyan 0.3 0.48 0.1 2.9</translation>
    </message>
    <message>
        <source>Sort the tones by ink: cyan, magenta, yellow, black, white</source>
        <translation>Ordene os tons por tinta: ciano, magenta, amarelo, preto, branco</translation>
    </message>
    <message>
        <source>Sort the tones of an ink by increasing density</source>
        <translation>Ordene os tons de uma tinta por densidade crescente</translation>
    </message>
    <message>
        <source>On film with an area stretch of %3, the patch of density %2 would look lighter than the patch of density %1; measure both again</source>
        <translation>Em película com estiramento de área %3, a amostra de densidade %2 pareceria mais clara que a de densidade %1; meça as duas de novo</translation>
    </message>
    <message>
        <source>A density must be from %1 to %2; zero the densitometer on film without ink, or leave the patch out</source>
        <translation>Uma densidade deve estar entre %1 e %2; zere o densitômetro em película sem tinta, ou deixe a amostra de fora</translation>
    </message>
    <message>
        <source>The stretched area must be %1 to %2 times the unstretched area; leave this reading out</source>
        <translation>A área estirada deve ser de %1 a %2 vezes a área sem estiramento; deixe esta leitura de fora</translation>
    </message>
    <message>
        <source>A wedge needs 1 to %1 patches with readings on stretched film</source>
        <translation>Uma cunha precisa de 1 a %1 amostras com leituras em película estirada</translation>
    </message>
    <message>
        <source>The readings of the patch of density %1 are impossible for ink; check that its densities and stretches are in the right rows</source>
        <translation>As leituras da amostra de densidade %1 são impossíveis para uma tinta; verifique se suas densidades e estiramentos estão nas linhas certas</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, linha %2</translation>
    </message>
</context>
<context>
    <name>dipwright::InspectionController</name>
    <message>
        <source>Reading photos</source>
        <translation>Lendo fotos</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>No photos yet</source>
        <translation>Ainda não há fotos</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lendo %1</translation>
    </message>
    <message>
        <source>Finding corners</source>
        <translation>Procurando cantos</translation>
    </message>
    <message>
        <source>Measuring pairs</source>
        <translation>Medindo pares</translation>
    </message>
    <message>
        <source>Wrote the residuals to %1</source>
        <translation>Desvios gravados em %1</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Dipped part</source>
        <translation>Peça mergulhada</translation>
    </message>
    <message>
        <source>As built</source>
        <translation>Como saiu</translation>
    </message>
    <message>
        <source>Film on the water</source>
        <translation>Película na água</translation>
    </message>
    <message>
        <source>Choose dipped image</source>
        <translation>Escolher imagem mergulhada</translation>
    </message>
    <message>
        <source>Choose kind of pairs</source>
        <translation>Escolher tipo de pares</translation>
    </message>
    <message>
        <source>The project refers to this photo:</source>
        <translation>O projeto se refere a esta foto:</translation>
    </message>
    <message>
        <source>The photo %1 has changed since its places were clicked.</source>
        <translation>A foto %1 mudou desde que seus pontos foram clicados.</translation>
    </message>
    <message>
        <source>Export residuals to a folder</source>
        <translation>Exportar desvios para uma pasta</translation>
    </message>
    <message>
        <source>Export residuals</source>
        <translation>Exportar desvios</translation>
    </message>
    <message>
        <source>The model&apos;s texture contains no chessboard squares, so there are no corners to find; dip the part with the chessboard film, or measure only the pairs</source>
        <translation>A textura do modelo não contém quadrados de xadrez, portanto não há cantos a procurar; mergulhe a peça com a película de xadrez ou meça só os pares</translation>
    </message>
</context>
<context>
    <name>dipwright::JigModel</name>
    <message>
        <source>The bounding boxes of this part and of %1 overlap; move the parts apart on the jig</source>
        <translation>As caixas envolventes desta peça e de %1 se sobrepõem; afaste as peças no suporte</translation>
    </message>
    <message>
        <source>A jig needs at least one part, and its parts may have at most %1 materials in all</source>
        <translation>Um suporte precisa de pelo menos uma peça, e suas peças podem ter no máximo %1 materiais ao todo</translation>
    </message>
</context>
<context>
    <name>dipwright::JobIndicator</name>
    <message>
        <source>Progress</source>
        <translation>Progresso</translation>
    </message>
    <message>
        <source>Estimated from the progress of the job.</source>
        <translation>Estimado pelo progresso da tarefa.</translation>
    </message>
</context>
<context>
    <name>dipwright::JobQueue</name>
    <message>
        <source>Cancelling …</source>
        <translation>Cancelando…</translation>
    </message>
    <message>
        <source>, failed: %1</source>
        <translation>, com falha: %1</translation>
    </message>
    <message>
        <source>, cancelled: %1</source>
        <translation>, cancelados: %1</translation>
    </message>
    <message>
        <source>Coverage %1 %</source>
        <translation>Cobertura %1 %</translation>
    </message>
    <message>
        <source>The queue has finished. Projects done: %1</source>
        <translation>A fila terminou. Projetos concluídos: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>Nada aconteceu ainda.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Limpar</translation>
    </message>
    <message>
        <source>Empties the log.</source>
        <translation>Esvazia o registro.</translation>
    </message>
    <message>
        <source>Copy report</source>
        <translation>Copiar relatório</translation>
    </message>
    <message>
        <source>Copies the log, with details of the program and the computer, to the clipboard.</source>
        <translation>Copia o registro, com dados do programa e do computador, para a área de transferência.</translation>
    </message>
</context>
<context>
    <name>dipwright::LookInsideBar</name>
    <message>
        <source>Show the other side</source>
        <translation>Mostrar o outro lado</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Position of the section through part and film. You can also drag its frame in the view.</source>
        <translation>Posição do corte pela peça e pela película. Você também pode arrastar a moldura na vista.</translation>
    </message>
    <message>
        <source>How opaque the film is. At 100 % it hides everything behind it.</source>
        <translation>Quão opaca é a película. A 100 % ela esconde tudo atrás dela.</translation>
    </message>
    <message>
        <source>Film opacity</source>
        <translation>Opacidade da película</translation>
    </message>
    <message>
        <source>Cut across X</source>
        <translation>Corte transversal a X</translation>
    </message>
    <message>
        <source>Horizontal cut, across Y</source>
        <translation>Horizontal, transversal a Y</translation>
    </message>
    <message>
        <source>Cut across Z</source>
        <translation>Corte transversal a Z</translation>
    </message>
    <message>
        <source>Axis perpendicular to the section plane</source>
        <translation>Eixo perpendicular ao plano de corte</translation>
    </message>
</context>
<context>
    <name>dipwright::MainWindow</name>
    <message>
        <source>Cancelling …</source>
        <translation>Cancelando…</translation>
    </message>
    <message>
        <source>Layout “%1”</source>
        <translation>Disposição “%1”</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Inspeção</translation>
    </message>
    <message>
        <source>The largest dimension of the part is %1. If the file uses another unit, change this dimension under Model.</source>
        <translation>A maior dimensão da peça é de %1. Se o arquivo usa outra unidade, mude esta dimensão em “Modelo”.</translation>
    </message>
</context>
<context>
    <name>dipwright::MarkFields</name>
    <message>
        <source>Marks nothing</source>
        <translation>Não marca nada</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Raio</translation>
    </message>
    <message>
        <source>Remove last</source>
        <translation>Remover a última</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Remover todas</translation>
    </message>
    <message>
        <source>A click on the part</source>
        <translation>Um clique na peça</translation>
    </message>
    <message>
        <source>Marks on the part: %1</source>
        <translation>Marcas na peça: %1</translation>
    </message>
    <message>
        <source>Click on part</source>
        <translation>Clique na peça</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Borracha</translation>
    </message>
    <message>
        <source>Radius of the brush on the part. The keys [ and ] change it.</source>
        <translation>Raio do pincel na peça. As teclas [ e ] o mudam.</translation>
    </message>
    <message>
        <source>Strokes on the part take the area out of the marks. Hold Shift to erase with a single stroke.</source>
        <translation>Pinceladas na peça retiram a área das marcas. Com Shift pressionado, uma única pincelada apaga.</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marcar</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Pelo nome</translation>
    </message>
    <message>
        <source>A face of the CAD model, or a material, by its name. The mark stays on it when the triangles are made again.</source>
        <translation>Uma face do modelo CAD, ou um material, pelo nome. A marca permanece nela quando os triângulos são refeitos.</translation>
    </message>
    <message>
        <source>Marks this face or material as chosen above.</source>
        <translation>Marca esta face ou este material como escolhido acima.</translation>
    </message>
</context>
<context>
    <name>dipwright::MaskFields</name>
    <message>
        <source>Masks with a brush</source>
        <translation>Mascara com um pincel</translation>
    </message>
    <message>
        <source>Masks a whole face</source>
        <translation>Mascara uma face inteira</translation>
    </message>
    <message>
        <source>What a click or drag on the part does. Masked surface must stay free of film: it is covered with tape, the sheet stays blank there, and the cradle may touch it.</source>
        <translation>O que um clique ou arrasto na peça faz. A superfície mascarada precisa ficar livre de película: ela é coberta com fita, a folha fica em branco ali, e o berço pode tocá-la.</translation>
    </message>
    <message>
        <source>Masks a whole material or CAD face</source>
        <translation>Mascara um material inteiro ou uma face CAD</translation>
    </message>
</context>
<context>
    <name>dipwright::MeasurePlot</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Colocação %1</translation>
    </message>
    <message>
        <source>Horizontal axis</source>
        <translation>Eixo horizontal</translation>
    </message>
    <message>
        <source>Vertical axis</source>
        <translation>Eixo vertical</translation>
    </message>
    <message>
        <source>Right and up is better. The line joins the poses that no other pose beats in both measures.</source>
        <translation>À direita e acima é melhor. A linha liga as poses que nenhuma outra supera em ambas as medidas.</translation>
    </message>
    <message>
        <source>better →</source>
        <translation>melhor →</translation>
    </message>
    <message>
        <source>%1: worst %2, best %3</source>
        <translation>%1: pior %2, melhor %3</translation>
    </message>
</context>
<context>
    <name>dipwright::MeasureTool</name>
    <message>
        <source>Distance %1</source>
        <translation>Distância %1</translation>
    </message>
    <message>
        <source>Click the second place on the part</source>
        <translation>Clique no segundo ponto da peça</translation>
    </message>
    <message>
        <source>%1, along the surface %2</source>
        <translation>%1, ao longo da superfície %2</translation>
    </message>
</context>
<context>
    <name>dipwright::ModelFile</name>
    <message>
        <source>a texture of the model</source>
        <translation>uma textura do modelo</translation>
    </message>
    <message>
        <source>The stored model is damaged; import the model again</source>
        <translation>O modelo guardado está danificado; importe o modelo de novo</translation>
    </message>
    <message>
        <source>The stored model has format version %1, but this program reads version %2; use a newer version of this program</source>
        <translation>O modelo guardado tem a versão de formato %1, mas este programa lê a versão %2; use uma versão mais nova deste programa</translation>
    </message>
</context>
<context>
    <name>dipwright::ModelFormats</name>
    <message>
        <source>%1 or %2</source>
        <extracomment>Names of file formats: &quot;OBJ, PLY, STL, glTF&quot; or &quot;3MF&quot;</extracomment>
        <translation>%1 ou %2</translation>
    </message>
</context>
<context>
    <name>dipwright::NewProjectDialog</name>
    <message>
        <source>Models (%1)</source>
        <translation>Modelos (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imagens (%1)</translation>
    </message>
    <message>
        <source>Dipwright projects (%1)</source>
        <translation>Projetos do Dipwright (%1)</translation>
    </message>
    <message>
        <source>One unit of the file is</source>
        <translation>Uma unidade do arquivo é</translation>
    </message>
    <message>
        <source>One dip</source>
        <translation>Uma imersão</translation>
    </message>
    <message>
        <source>Two dips: bottom and top</source>
        <translation>Duas imersões: embaixo e em cima</translation>
    </message>
    <message>
        <source>Two dips: left and right</source>
        <translation>Duas imersões: esquerda e direita</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Modelo</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>Te&amp;xtura</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>&amp;Film</source>
        <translation>Pelíc&amp;ula</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Criar</translation>
    </message>
    <message>
        <source>a millimetre</source>
        <translation>um milímetro</translation>
    </message>
    <message>
        <source>a centimetre</source>
        <translation>um centímetro</translation>
    </message>
    <message>
        <source>a metre</source>
        <translation>um metro</translation>
    </message>
    <message>
        <source>an inch</source>
        <translation>uma polegada</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Unidade do arquivo</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Embaixo</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Em cima</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>Reading the model …</source>
        <translation>Lendo o modelo…</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Lendo o modelo</translation>
    </message>
    <message>
        <source>Film &amp;profile</source>
        <translation>&amp;Perfil da película</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Novo projeto</translation>
    </message>
    <message>
        <source>The model&apos;s own texture</source>
        <translation>A textura do próprio modelo</translation>
    </message>
    <message>
        <source>A picture that replaces the model&apos;s own texture. Leave it empty to keep the model&apos;s texture.</source>
        <translation>Uma imagem que substitui a textura do próprio modelo. Deixe vazio para manter a textura do modelo.</translation>
    </message>
    <message>
        <source>The size of the film as it is delivered and printed.</source>
        <translation>O tamanho em que a película é fornecida e impressa.</translation>
    </message>
    <message>
        <source>The measured properties of the film: how it swells, grows and tears.</source>
        <translation>As propriedades medidas da película: como incha, cresce e rasga.</translation>
    </message>
    <message>
        <source>How many times the part is dipped, and from which sides. You can change this later.</source>
        <translation>Quantas vezes e de que lados a peça é mergulhada. Você pode mudar isso depois.</translation>
    </message>
    <message>
        <source>Choose a model</source>
        <translation>Escolher um modelo</translation>
    </message>
    <message>
        <source>Choose a texture</source>
        <translation>Escolher uma textura</translation>
    </message>
    <message>
        <source>&amp;Dips</source>
        <translation>&amp;Imersões</translation>
    </message>
    <message>
        <source>The unit of the coordinates in the model file. The file itself does not state it.</source>
        <translation>A unidade das coordenadas no arquivo do modelo. O próprio arquivo não a informa.</translation>
    </message>
    <message>
        <source>The part measures %1 × %2 × %3</source>
        <translation>A peça mede %1 × %2 × %3</translation>
    </message>
    <message>
        <source>the unit was guessed from the size.</source>
        <translation>a unidade foi suposta pelo tamanho.</translation>
    </message>
    <message>
        <source>The largest dimension is</source>
        <translation>A maior dimensão é</translation>
    </message>
    <message>
        <source>One dip with the film model of the 2020 paper, for comparison</source>
        <translation>Uma imersão com o modelo de película do artigo de 2020, para comparação</translation>
    </message>
    <message>
        <source>Largest dimension</source>
        <translation>Maior dimensão</translation>
    </message>
    <message>
        <source>Scales the model so that its largest dimension (along X, Y or Z) has this length.</source>
        <translation>Redimensiona o modelo para que sua maior dimensão (ao longo de X, Y ou Z) tenha este comprimento.</translation>
    </message>
    <message>
        <source>Choose a model file</source>
        <translation>Escolha o arquivo do modelo</translation>
    </message>
    <message>
        <source>The model file of the part to dip: %1.</source>
        <translation>O arquivo do modelo da peça a mergulhar: %1.</translation>
    </message>
    <message>
        <source>Create and &amp;run</source>
        <translation>Criar e e&amp;xecutar</translation>
    </message>
    <message>
        <source>Creates the project and simulates its dips at once.</source>
        <translation>Cria o projeto e simula suas imersões na hora.</translation>
    </message>
</context>
<context>
    <name>dipwright::NoticeBar</name>
    <message>
        <source>Close this notice</source>
        <translation>Fechar este aviso</translation>
    </message>
</context>
<context>
    <name>dipwright::NumberBox</name>
    <message>
        <source>“%1” has a unit, but this field has none; type only the number</source>
        <translation>“%1” tem uma unidade, mas este campo não tem nenhuma; digite só o número</translation>
    </message>
    <message>
        <source>“%1” has a unit that does not fit this field; type a number in %2</source>
        <translation>“%1” tem uma unidade que não serve para este campo; digite um número em %2</translation>
    </message>
    <message>
        <source>“%1” is not a number</source>
        <translation>“%1” não é um número</translation>
    </message>
    <message>
        <source>“%1” is outside the range %2 to %3%4</source>
        <translation>“%1” está fora da faixa de %2 a %3%4</translation>
    </message>
    <message>
        <source>“%1” is not a whole number</source>
        <translation>“%1” não é um número inteiro</translation>
    </message>
    <message>
        <source>The field is empty; type a number</source>
        <translation>O campo está vazio; digite um número</translation>
    </message>
    <message>
        <source>“%1” can mean %2 or %3; type one of them</source>
        <translation>“%1” pode significar %2 ou %3; digite um deles</translation>
    </message>
    <message>
        <source>“%1” is not a unit that this field knows; type a number in %2</source>
        <translation>“%1” não é uma unidade que este campo conhece; digite um número em %2</translation>
    </message>
</context>
<context>
    <name>dipwright::NumericalErrorCheck</name>
    <message>
        <source>Checking the numerical error</source>
        <translation>Verificando o erro numérico</translation>
    </message>
    <message>
        <source>Check numerical error</source>
        <translation>Verificar erro numérico</translation>
    </message>
</context>
<context>
    <name>dipwright::NumericalErrorDialog</name>
    <message>
        <source>%1: this sheet is not accurate enough. For 95 % of it, the numerical error is up to %2. Use smaller film cells or more points, or turn the part.</source>
        <translation>%1: esta folha não é exata o bastante. Em 95 % dela, o erro numérico chega a %2. Use células menores ou mais pontos na película, ou gire a peça.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Média</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Painted in both</source>
        <translation>Pintado em ambos</translation>
    </message>
    <message>
        <source>Painted in one</source>
        <translation>Pintado em só um</translation>
    </message>
    <message>
        <source>Share of the part&apos;s surface that is painted in both computations</source>
        <translation>Fração da superfície da peça pintada em ambos os cálculos</translation>
    </message>
    <message>
        <source>Share of the part&apos;s surface that is painted in only one of the two computations</source>
        <translation>Fração da superfície da peça pintada em só um dos dois cálculos</translation>
    </message>
    <message>
        <source>With half the step</source>
        <translation>Com metade do passo</translation>
    </message>
    <message>
        <source>With half the cell width</source>
        <translation>Com metade da largura da célula</translation>
    </message>
    <message>
        <source>Numerical error of the sheet</source>
        <translation>Erro numérico da folha</translation>
    </message>
    <message>
        <source>%1: the dip paints nothing, so there is nothing to compare.</source>
        <translation>%1: a imersão não pinta nada, portanto não há o que comparar.</translation>
    </message>
    <message>
        <source>Numerical error of the sheets</source>
        <translation>Erro numérico das folhas</translation>
    </message>
    <message>
        <source>&amp;Save maps…</source>
        <translation>&amp;Salvar mapas…</translation>
    </message>
    <message>
        <source>The project has changed since these figures were computed.</source>
        <translation>O projeto mudou desde que estes números foram calculados.</translation>
    </message>
    <message>
        <source>Save maps to a folder</source>
        <translation>Salvar mapas em uma pasta</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>Percentil 95</translation>
    </message>
    <message>
        <source>How far the image on the sheet moves with half the step or half the cell width</source>
        <translation>Quanto a imagem na folha se desloca com metade do passo ou da largura da célula</translation>
    </message>
    <message>
        <source>%1: this sheet is accurate enough. For 95 % of it, the numerical error is at most %2.</source>
        <translation>%1: esta folha é exata o bastante. Em 95 % dela, o erro numérico é de no máximo %2.</translation>
    </message>
</context>
<context>
    <name>dipwright::OrientationMap</name>
    <message>
        <source>Which side
goes down first</source>
        <translation>Que lado
desce primeiro</translation>
    </message>
    <message>
        <source>Rating of each side when it goes down first</source>
        <translation>Avaliação de cada lado ao descer primeiro</translation>
    </message>
    <message>
        <source>Objective %1; click to turn this side down</source>
        <translation>Objetivo %1; clique para virar este lado para baixo</translation>
    </message>
</context>
<context>
    <name>dipwright::OutputsDialog</name>
    <message>
        <source>Overwrite files that were not made here</source>
        <translation>Sobrescrever arquivos que não foram gerados aqui</translation>
    </message>
    <message>
        <source>Clip what lies outside the printable area</source>
        <translation>Cortar o que fica fora da área imprimível</translation>
    </message>
    <message>
        <source>&amp;Save set</source>
        <translation>&amp;Salvar conjunto</translation>
    </message>
    <message>
        <source>&amp;Remove set</source>
        <translation>&amp;Remover conjunto</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Escolher…</translation>
    </message>
    <message>
        <source>Make outputs</source>
        <translation>Gerar saídas</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Saídas</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Saída</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Arquivos</translation>
    </message>
    <message>
        <source>These results were made before the last changes to the project. Run the dip again for outputs of the current state.</source>
        <translation>Estes resultados são anteriores às últimas alterações do projeto. Execute a imersão de novo para ter saídas do estado atual.</translation>
    </message>
    <message>
        <source>Cancelled. Outputs that were finished before stay.</source>
        <translation>Cancelado. As saídas que já estavam prontas ficam.</translation>
    </message>
    <message>
        <source>Output set</source>
        <translation>Conjunto de saídas</translation>
    </message>
    <message>
        <source>A named list of outputs. To make an own set, tick its outputs, type a name and save it. It is kept with the project; the command line makes the same files with run --outputs NAME.</source>
        <translation>Uma lista de saídas com nome. Para um conjunto próprio, marque suas saídas, digite um nome e salve. Ele fica no projeto; a linha de comando gera os mesmos arquivos com run --outputs NOME.</translation>
    </message>
    <message>
        <source>Keeps the ticked outputs under this name in the project. This can be undone.</source>
        <translation>Guarda as saídas marcadas com este nome no projeto. Isto pode ser desfeito.</translation>
    </message>
    <message>
        <source>Removes this set from the project. This can be undone.</source>
        <translation>Remove este conjunto do projeto. Isto pode ser desfeito.</translation>
    </message>
    <message>
        <source>S&amp;et</source>
        <translation>Con&amp;junto</translation>
    </message>
    <message>
        <source>The folder that the files are written to. It is made if it does not exist.</source>
        <translation>A pasta em que os arquivos são gravados. Ela é criada se não existir.</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Pasta</translation>
    </message>
    <message>
        <source>If this is not ticked, an output fails rather than replace a file that it has not made, or that was changed since.</source>
        <translation>Sem a marca, uma saída falha em vez de substituir um arquivo que ela não gerou ou que foi alterado depois.</translation>
    </message>
    <message>
        <source>For sheets in the printer&apos;s colours: if this is not ticked, they fail if colour lies where the printer cannot print.</source>
        <translation>Para folhas nas cores da impressora: sem a marca, elas falham se houver cor onde a impressora não alcança.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>&amp;Make outputs</source>
        <translation>&amp;Gerar saídas</translation>
    </message>
    <message>
        <source>Writes the files of all ticked outputs.</source>
        <translation>Grava os arquivos de todas as saídas marcadas.</translation>
    </message>
    <message>
        <source>Save output set “%1”</source>
        <translation>Salvar conjunto de saídas “%1”</translation>
    </message>
    <message>
        <source>The set “%1” is kept with the project.</source>
        <translation>O conjunto “%1” fica no projeto.</translation>
    </message>
    <message>
        <source>Remove output set “%1”</source>
        <translation>Remover conjunto de saídas “%1”</translation>
    </message>
    <message>
        <source>Folder of the outputs</source>
        <translation>Pasta das saídas</translation>
    </message>
    <message>
        <source>Looking for outputs</source>
        <translation>Procurando saídas</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Pronto</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Desatualizado</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Falhou</translation>
    </message>
    <message>
        <source>Not made</source>
        <translation>Não gerado</translation>
    </message>
    <message>
        <source>Making outputs …</source>
        <translation>Gerando saídas …</translation>
    </message>
    <message>
        <source>Making outputs</source>
        <translation>Gerando saídas</translation>
    </message>
    <message>
        <source>Made the outputs in %1</source>
        <translation>As saídas foram geradas em %1</translation>
    </message>
    <message>
        <source>Outputs that failed: %1 of %2</source>
        <translation>Saídas que falharam: %1 de %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>dipwright::PackDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Add projects and lay them out.</source>
        <translation>Adicione projetos e disponha-os.</translation>
    </message>
    <message>
        <source>Projects on the film</source>
        <translation>Projetos na película</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Cópias</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remover</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rolo</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Short edge first</source>
        <translation>Borda curta primeiro</translation>
    </message>
    <message>
        <source>Long edge first</source>
        <translation>Borda longa primeiro</translation>
    </message>
    <message>
        <source>&amp;Film</source>
        <translation>Pelíc&amp;ula</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largura</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Comprimento</translation>
    </message>
    <message>
        <source>Fe&amp;ed</source>
        <translation>Alime&amp;ntação</translation>
    </message>
    <message>
        <source>&amp;Bare film</source>
        <translation>Película l&amp;ivre</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Im&amp;primir…</translation>
    </message>
    <message>
        <source>Copies of %1</source>
        <translation>Cópias de %1</translation>
    </message>
    <message>
        <source>Laying out</source>
        <translation>Dispondo</translation>
    </message>
    <message>
        <source>Films: %1. They are printed at true size.</source>
        <translation>Películas: %1. São impressas em tamanho real.</translation>
    </message>
    <message>
        <source>Writing the films</source>
        <translation>Gravando as películas</translation>
    </message>
    <message>
        <source>Wrote the films to %1</source>
        <translation>Películas gravadas em %1</translation>
    </message>
    <message>
        <source>Several jobs</source>
        <translation>Vários trabalhos</translation>
    </message>
    <message>
        <source>Film %1</source>
        <translation>Película %1</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>&amp;Turn pieces to save film</source>
        <translation>&amp;Girar pedaços para poupar película</translation>
    </message>
    <message>
        <source>Several jobs on one film</source>
        <translation>Vários trabalhos em uma película</translation>
    </message>
    <message>
        <source>You can drop project files here. The last saved version of each file is used.</source>
        <translation>Você pode soltar arquivos de projeto aqui. É usada a última versão salva de cada arquivo.</translation>
    </message>
    <message>
        <source>&amp;Add projects…</source>
        <translation>&amp;Adicionar projetos…</translation>
    </message>
    <message>
        <source>The edge that enters the printer first. Film swells more along its web. A piece that swells unequally keeps its direction along the web.</source>
        <translation>A borda que entra primeiro na impressora. A película incha mais ao longo da bobina. Um pedaço que incha de modo desigual mantém sua direção em relação à bobina.</translation>
    </message>
    <message>
        <source>Turns pieces by 90°, but only if their film swells equally in both directions.</source>
        <translation>Gira pedaços em 90°, mas só se a película incha igualmente nos dois sentidos.</translation>
    </message>
    <message>
        <source>Shown film</source>
        <translation>Película mostrada</translation>
    </message>
    <message>
        <source>La&amp;y out</source>
        <translation>Di&amp;spor</translation>
    </message>
    <message>
        <source>Simulates the projects that have no result yet, then lays out all pieces.</source>
        <translation>Simula os projetos que ainda não têm resultado e depois dispõe todos os pedaços.</translation>
    </message>
    <message>
        <source>Writes each film as PDF, PNG and TIFF at true size, and a list of the pieces with their places.</source>
        <translation>Grava cada película em PDF, PNG e TIFF em tamanho real e uma lista dos pedaços com seus lugares.</translation>
    </message>
    <message>
        <source>Add projects</source>
        <translation>Adicionar projetos</translation>
    </message>
    <message>
        <source>The largest length. The roll is cut off after the last piece.</source>
        <translation>O maior comprimento. O rolo é cortado depois do último pedaço.</translation>
    </message>
    <message>
        <source>Export films to a folder</source>
        <translation>Exportar películas para uma pasta</translation>
    </message>
    <message>
        <source>Press “Lay out”. Projects that have no result yet are simulated first.</source>
        <translation>Pressione “Dispor”. Os projetos que ainda não têm resultado são simulados antes.</translation>
    </message>
    <message>
        <source>Add projects or drop their files here.</source>
        <translation>Adicione projetos ou solte seus arquivos aqui.</translation>
    </message>
    <message>
        <source>Width of the bare film around the ink. Choose it wide: each job is computed for its whole film, and a piece that is cut close to the ink behaves differently near its edge.</source>
        <translation>Largura da película livre em volta da tinta. Escolha-a grande: cada trabalho é calculado para a película inteira, e um pedaço cortado perto da tinta se comporta de outro modo na borda.</translation>
    </message>
    <message>
        <source>&amp;Spacing between pieces</source>
        <translation>&amp;Espaçamento entre pedaços</translation>
    </message>
    <message>
        <source>The film or roll on which the pieces are placed.</source>
        <translation>A película ou o rolo em que as partes são colocadas.</translation>
    </message>
    <message>
        <source>Width of the film or roll.</source>
        <translation>Largura da película ou do rolo.</translation>
    </message>
    <message>
        <source>Least distance between two pieces.</source>
        <translation>Menor distância entre duas partes.</translation>
    </message>
    <message>
        <source>The film that the preview shows.</source>
        <translation>A película que a prévia mostra.</translation>
    </message>
    <message>
        <source>How many copies of the project are placed on the film.</source>
        <translation>Quantas cópias do projeto são colocadas na película.</translation>
    </message>
    <message>
        <source>W&amp;hole sheets with cut marks</source>
        <translation>Fol&amp;has inteiras com marcas de corte</translation>
    </message>
    <message>
        <source>Places whole sheets with their own marks, for an unattended series on a roll. Cut marks and the number of each copy stand in the gaps; 5 to 20 mm are usual. Otherwise only the printed parts are placed.</source>
        <translation>Põe folhas inteiras com suas próprias marcas, para uma série sem supervisão em um rolo. Nos espaços ficam as marcas de corte e o número de cada cópia; são usuais de 5 a 20 mm. Caso contrário, só são postas as partes impressas.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredito</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>In exported files: %1.</source>
        <translation>Nos arquivos exportados: %1.</translation>
    </message>
</context>
<context>
    <name>dipwright::PaintArtwork</name>
    <message>
        <source>The artwork does not fit into this computer&apos;s memory; choose a lower resolution of the sheet</source>
        <translation>A arte não cabe na memória deste computador; escolha uma resolução menor da folha</translation>
    </message>
    <message>
        <source>Painting the artwork</source>
        <translation>Pintando a arte</translation>
    </message>
</context>
<context>
    <name>dipwright::PartCamera</name>
    <message>
        <source>Finding corners in photo %1</source>
        <translation>Procurando cantos na foto %1</translation>
    </message>
    <message>
        <source>In photo %1, black and white are swapped; the film was laid with its ink side down, or shifted by one square</source>
        <translation>Na foto %1 o preto e o branco estão trocados; a película foi posta com o lado da tinta para baixo ou deslocada de um quadrado</translation>
    </message>
    <message>
        <source>Photo %2 should show %1 corners, but only %3 were found; check that it shows this job&apos;s part and print, whole and sharp, and that its places are correct</source>
        <translation>A foto %2 deveria mostrar %1 cantos, mas só %3 foram encontrados; verifique se ela mostra a peça e a impressão deste trabalho, inteiras e nítidas, e se os pontos estão certos</translation>
    </message>
    <message>
        <source>Photo %1 has %2 pairs of places, but its camera needs %3; give more pairs</source>
        <translation>A foto %1 tem %2 pares de lugares, mas sua câmera precisa de %3; dê mais pares</translation>
    </message>
    <message>
        <source>All places of photo %1 lie in one plane, which does not determine the camera&apos;s distance; give some places on other faces</source>
        <translation>Todos os lugares da foto %1 ficam num plano, o que não determina a distância da câmera; dê alguns lugares em outras faces</translation>
    </message>
    <message>
        <source>The pairs do not determine the camera; give more pairs, farther apart</source>
        <translation>Os pares não determinam a câmera; dê mais pares, mais afastados</translation>
    </message>
    <message>
        <source>The pairs do not determine the camera&apos;s distance; add pairs at places nearer to the camera and farther from it, or take the photo from a shorter distance</source>
        <translation>Os pares não determinam a distância da câmera; acrescente pares em lugares mais próximos e mais distantes da câmera, ou tire a foto de uma distância menor</translation>
    </message>
    <message>
        <source>The first line of the pairs must be %1</source>
        <translation>A primeira linha dos pares deve ser %1</translation>
    </message>
    <message>
        <source>Line %1 of the pairs must contain %2</source>
        <translation>A linha %1 dos pares deve conter %2</translation>
    </message>
    <message>
        <source>There are more than %1 pairs; give fewer</source>
        <translation>Há mais de %1 pares; dê menos</translation>
    </message>
    <message>
        <source>a photo number, two coordinates in pixels and three in millimetres, separated by commas</source>
        <translation>um número de foto, duas coordenadas em pixels e três em milímetros, separados por vírgulas</translation>
    </message>
    <message>
        <source>a photo number, two coordinates in pixels, a dip number, two sheet coordinates and three model coordinates in millimetres, separated by commas</source>
        <translation>um número de foto, duas coordenadas em pixels, um número de imersão, duas coordenadas na folha e três no modelo em milímetros, separados por vírgulas</translation>
    </message>
    <message>
        <source>The photos have different sizes; use photos of one camera, held the same way</source>
        <translation>As fotos têm tamanhos diferentes; use fotos de uma só câmera, segurada do mesmo modo</translation>
    </message>
    <message>
        <source>With this photo, the part&apos;s photos have %1 million pixels in total, but the limit is %2 million; use fewer or smaller photos</source>
        <translation>Com esta foto, as fotos da peça têm no total %1 milhões de pixels, mas o limite é %2 milhões; use menos fotos ou fotos menores</translation>
    </message>
    <message>
        <source>According to the places given for it, photo %1 shows none of the print; give the places again, or photograph the dipped side</source>
        <translation>Pelos pontos indicados para ela, a foto %1 não mostra nada da impressão; indique os pontos de novo, ou fotografe o lado mergulhado</translation>
    </message>
    <message>
        <source>The places marked in photo %1 are a mirror image of the places on the model; use the photo unflipped, and give the places in the model&apos;s own coordinates</source>
        <translation>Os lugares marcados na foto %1 são uma imagem espelhada dos lugares no modelo; use a foto sem espelhá-la e dê os lugares nas coordenadas do próprio modelo</translation>
    </message>
    <message>
        <source>Line %1 of the pairs names a place outside the photo, which has %2 × %3 pixels; correct the place</source>
        <translation>A linha %1 dos pares indica um lugar fora da foto, que tem %2 × %3 pixels; corrija o lugar</translation>
    </message>
    <message>
        <source>The corners found are %1 of a square from their expected places (median). Above %2, a corner may be confused with the one a diagonal away, so check one corner on the part by hand, or use larger squares</source>
        <translation>Os cantos encontrados estão a %1 de um quadrado de seus lugares esperados (mediana). Acima de %2, um canto pode ser confundido com o vizinho na diagonal; por isso, verifique um canto na peça à mão ou use quadrados maiores</translation>
    </message>
    <message>
        <source>Rings: expected places · lines: deviations of the seen places, scale %1:1</source>
        <translation>Anéis: lugares esperados · linhas: desvios dos lugares vistos, escala %1:1</translation>
    </message>
</context>
<context>
    <name>dipwright::PartPage</name>
    <message>
        <source>Photo of the dipped part</source>
        <translation>Foto da peça mergulhada</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Remove this photo and its pairs</source>
        <translation>Remover esta foto e seus pares</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Imagem inteira</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Ampliar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Reduzir</translation>
    </message>
    <message>
        <source>Photos (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Photo %1</source>
        <translation>Foto %1</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>%1 of %2 corners found.</source>
        <translation>%1 de %2 cantos encontrados.</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>R ± σ, px</source>
        <translation>R ± σ, px</translation>
    </message>
    <message>
        <source>R, %</source>
        <translation>R, %</translation>
    </message>
    <message>
        <source>95 %, mm</source>
        <translation>95 %, mm</translation>
    </message>
    <message>
        <source>Error of the image on the part</source>
        <translation>Erro da imagem na peça</translation>
    </message>
    <message>
        <source>Add &amp;photos…</source>
        <translation>Adicionar &amp;fotos…</translation>
    </message>
    <message>
        <source>Remove photo</source>
        <translation>Remover foto</translation>
    </message>
    <message>
        <source>Photos of the dipped part</source>
        <translation>Fotos da peça mergulhada</translation>
    </message>
    <message>
        <source>Dipped with the c&amp;hessboard film (17 mm)</source>
        <translation>Mergulhada com a película de &amp;xadrez (17 mm)</translation>
    </message>
    <message>
        <source>&amp;Measure pairs</source>
        <translation>&amp;Medir pares</translation>
    </message>
    <message>
        <source>Fits the camera to the pairs and shows their residuals</source>
        <translation>Ajusta a câmera aos pares e mostra os desvios</translation>
    </message>
    <message>
        <source>&amp;Find corners</source>
        <translation>Pro&amp;curar cantos</translation>
    </message>
    <message>
        <source>Finds the corners of the image in all photos and compares them with the simulated film</source>
        <translation>Procura os cantos da imagem em todas as fotos e os compara com a película simulada</translation>
    </message>
    <message>
        <source>&amp;Remove pair</source>
        <translation>&amp;Remover par</translation>
    </message>
    <message>
        <source>Writes the table, the places and the photos with residuals to a folder</source>
        <translation>Grava a tabela, os pontos e as fotos com desvios em uma pasta</translation>
    </message>
    <message>
        <source>Now click the same place on the part in the 3D view.</source>
        <translation>Agora clique no mesmo ponto da peça na vista 3D.</translation>
    </message>
    <message>
        <source>The camera was fitted to the pairs.</source>
        <translation>A câmera foi ajustada aos pares.</translation>
    </message>
    <message>
        <source>N: number of measured places</source>
        <translation>N: número de pontos medidos</translation>
    </message>
    <message>
        <source>The camera was fitted to the printed pattern, so a shift or rotation of the whole image is not measured.</source>
        <translation>A câmera foi ajustada ao padrão impresso; por isso, um deslocamento ou giro da imagem inteira não é medido.</translation>
    </message>
    <message>
        <source>Largest, mm</source>
        <translation>Maior, mm</translation>
    </message>
    <message>
        <source>R: mean distance in the photo between the measured and the expected position of a place, ± standard deviation σ, in pixels</source>
        <translation>R: distância média na foto entre a posição medida e a posição esperada de um ponto, ± desvio padrão σ, em pixels</translation>
    </message>
    <message>
        <source>R as a share of the photo&apos;s diagonal, as in Table II of the 2020 paper</source>
        <translation>R como porcentagem da diagonal da foto, como na Tabela II do artigo de 2020</translation>
    </message>
    <message>
        <source>95 % of the places on the part are within this distance of their expected positions, measured perpendicular to the line of sight</source>
        <translation>95 % dos pontos na peça ficam a menos desta distância de sua posição esperada, medida perpendicularmente à linha de visão</translation>
    </message>
    <message>
        <source>Largest distance of a place on the part from its expected position, measured perpendicular to the line of sight</source>
        <translation>Maior distância de um ponto na peça à sua posição esperada, medida perpendicularmente à linha de visão</translation>
    </message>
    <message>
        <source>If ticked, the program looks for the corners of the built-in chessboard. Otherwise it looks for chessboard squares in the model&apos;s texture.</source>
        <translation>Se marcado, o programa procura os cantos do tabuleiro de xadrez incluído. Senão, procura quadrados de xadrez na textura do modelo.</translation>
    </message>
    <message>
        <source>The pairs mark the part &amp;itself, not the image</source>
        <translation>Os pares marcam a própria peç&amp;a, não a imagem</translation>
    </message>
    <message>
        <source>Tick this if the pairs are tips and edges of the part, not places in the image. Then the camera is fitted only to the pairs, so that a shift of the whole image becomes visible.</source>
        <translation>Marque se os pares são pontas e arestas da peça, não lugares na imagem. Então a câmera é ajustada só aos pares, e um deslocamento da imagem inteira fica visível.</translation>
    </message>
    <message>
        <source>Add photos of the dipped part, or drop them here. Take all photos with the same camera. The part must be sharp, completely visible and fill the picture.</source>
        <translation>Adicione fotos da peça mergulhada ou solte-as aqui. Tire todas as fotos com a mesma câmera. A peça deve estar nítida, aparecer inteira e encher a imagem.</translation>
    </message>
    <message>
        <source>Click a place in the photo, then the same place on the part in the 3D view. %1 of %2 pairs so far; spread them over several faces.</source>
        <translation>Clique em um ponto na foto e depois no mesmo ponto da peça na vista 3D. Até agora %1 de %2 pares; distribua-os por várias faces.</translation>
    </message>
    <message>
        <source>%1 pairs. Drag a place to correct it, or press Delete to remove it. Then click “Find corners”, or click “Measure pairs” to use only the pairs.</source>
        <translation>%1 pares. Arraste um ponto para corrigi-lo, ou pressione Delete para removê-lo. Depois clique em “Procurar cantos”, ou em “Medir pares” para usar só os pares.</translation>
    </message>
    <message>
        <source>The photo that is shown.</source>
        <translation>A foto mostrada.</translation>
    </message>
</context>
<context>
    <name>dipwright::PathKeyFields</name>
    <message>
        <source>Add pose</source>
        <translation>Adicionar pose</translation>
    </message>
    <message>
        <source>Remove pose</source>
        <translation>Remover pose</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Poses</translation>
    </message>
    <message>
        <source>The poses that the part takes in turn. The view shows the chosen pose; its rings and arrows change it.</source>
        <translation>As poses que a peça assume uma após a outra. A vista mostra a pose escolhida; seus anéis e setas a mudam.</translation>
    </message>
    <message>
        <source>Adds a pose between the chosen one and the next.</source>
        <translation>Adiciona uma pose entre a escolhida e a seguinte.</translation>
    </message>
    <message>
        <source>Removes the chosen pose. The first and the last one stay.</source>
        <translation>Remove a pose escolhida. A primeira e a última ficam.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Depth of the part&apos;s lowest point. In the first pose it touches the water, in the last one it is at the depth of the dip.</source>
        <translation>Profundidade do ponto mais baixo da peça. Na primeira pose ele toca a água, na última está na profundidade da imersão.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidade</translation>
    </message>
    <message>
        <source>How far the part has moved along %1 from its offset.</source>
        <translation>Quanto a peça se moveu ao longo de %1 a partir de seu deslocamento.</translation>
    </message>
    <message>
        <source>Moved along %1</source>
        <translation>Movida ao longo de %1</translation>
    </message>
    <message>
        <source>How far the part is turned about %1 from its rotation at the end of the dip; about X first, then Y, then Z.</source>
        <translation>Quanto a peça está girada em torno de %1 a partir de sua rotação no fim da imersão; primeiro em torno de X, depois Y, depois Z.</translation>
    </message>
    <message>
        <source>Turned about %1</source>
        <translation>Girada em torno de %1</translation>
    </message>
    <message>
        <source>end</source>
        <translation>fim</translation>
    </message>
    <message>
        <source>%1: %2 s, depth %3</source>
        <translation>%1: %2 s, profundidade %3</translation>
    </message>
    <message>
        <source>When the part takes this pose, since the dip began. With a limit of the acceleration the part may take it later.</source>
        <translation>Quando a peça assume esta pose, desde o início da imersão. Com um limite de aceleração, a peça pode assumi-la mais tarde.</translation>
    </message>
</context>
<context>
    <name>dipwright::PhotoView</name>
    <message>
        <source>Lines: residuals, scale %1:1</source>
        <translation>Linhas: desvios, escala %1:1</translation>
    </message>
</context>
<context>
    <name>dipwright::PicturePanel</name>
    <message>
        <source>Whole picture</source>
        <translation>Imagem inteira</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Ampliar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Reduzir</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>True size</source>
        <translation>Tamanho real</translation>
    </message>
</context>
<context>
    <name>dipwright::PlatesDialog</name>
    <message>
        <source>Cyan</source>
        <translation>Ciano</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Amarelo</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Preto</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>Chapas</translation>
    </message>
    <message>
        <source>Plates need a printer profile with an ICC profile in CMYK. Choose one under Sheet in the project, and run the dip again.</source>
        <translation>As chapas precisam de um perfil de impressora com perfil ICC em CMYK. Escolha um no projeto, em Folha, e rode a imersão de novo.</translation>
    </message>
    <message>
        <source>&amp;All plates</source>
        <translation>&amp;Todas as chapas</translation>
    </message>
    <message>
        <source>&amp;Only this plate</source>
        <translation>&amp;Só esta chapa</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Parar</translation>
    </message>
    <message>
        <source>Wheel or + and − zoom, dragging or the arrow keys move the picture. Ctrl and the arrow keys move the place whose ink is shown, by one pixel; with Shift by ten.</source>
        <translation>A roda ou + e − mudam o zoom; arrastar ou as setas movem a imagem. Ctrl e as setas movem o lugar cuja tinta é mostrada, um pixel; com Shift, dez.</translation>
    </message>
    <message>
        <source>Stops the computation. Choose another view or sheet to start again.</source>
        <translation>Para o cálculo. Escolha outra vista ou folha para recomeçar.</translation>
    </message>
    <message>
        <source>The dip whose sheet is shown.</source>
        <translation>A imersão cuja folha é mostrada.</translation>
    </message>
    <message>
        <source>Ticked plates in ink colours</source>
        <translation>Chapas marcadas em suas cores</translation>
    </message>
    <message>
        <source>Selected plate in grey</source>
        <translation>Chapa selecionada em cinza</translation>
    </message>
    <message>
        <source>Total ink of the four inks</source>
        <translation>Tinta total das quatro tintas</translation>
    </message>
    <message>
        <source>What the picture shows. In grey, black is full ink. Total ink is the sum of cyan, magenta, yellow and black; red is above the limit.</source>
        <translation>O que a imagem mostra. Em cinza, preto é tinta plena. A tinta total é a soma de ciano, magenta, amarelo e preto; vermelho está acima do limite.</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Branco</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Cinza</translation>
    </message>
    <message>
        <source>Colour of the part</source>
        <translation>Cor da peça</translation>
    </message>
    <message>
        <source>What lies beneath the inks in the picture. White ink shows only on another ground than white.</source>
        <translation>O que fica sob as tintas na imagem. A tinta branca só aparece sobre um fundo que não seja branco.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>The largest sum of the four inks that the film carries. Places above it are marked and measured. It starts at the printer profile&apos;s total area coverage. Usual: 200 to 300 %. The print does not change.</source>
        <translation>A maior soma das quatro tintas que a película suporta. Lugares acima dela são marcados e medidos. Começa com a cobertura total do perfil da impressora. Usual: 200 a 300 %. A impressão não muda.</translation>
    </message>
    <message>
        <source>S&amp;heet</source>
        <translation>F&amp;olha</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>&amp;Fundo</translation>
    </message>
    <message>
        <source>Total ink &amp;limit</source>
        <translation>&amp;Limite da tinta total</translation>
    </message>
    <message>
        <source>Plates in printing order</source>
        <translation>Chapas na ordem de impressão</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Chapa</translation>
    </message>
    <message>
        <source>Cursor %</source>
        <translation>Cursor %</translation>
    </message>
    <message>
        <source>Largest %</source>
        <translation>Maior %</translation>
    </message>
    <message>
        <source>Full ink</source>
        <translation>Tinta plena</translation>
    </message>
    <message>
        <source>The ink under the cursor, as a share of full ink.</source>
        <translation>A tinta sob o cursor, como parte da tinta plena.</translation>
    </message>
    <message>
        <source>The largest share of ink on the film.</source>
        <translation>A maior parte de tinta na película.</translation>
    </message>
    <message>
        <source>How much ink the plate takes, as the area that it would cover at full ink.</source>
        <translation>Quanta tinta a chapa usa, como a área que cobriria com tinta plena.</translation>
    </message>
    <message>
        <source>Tick the plates that the picture shows. Space changes the selected plate, a double-click shows only that plate.</source>
        <translation>Marque as chapas que a imagem mostra. Espaço muda a chapa selecionada; um clique duplo mostra só essa chapa.</translation>
    </message>
    <message>
        <source>Making the plates</source>
        <translation>Gerando as chapas</translation>
    </message>
    <message>
        <source>Measuring the plates</source>
        <translation>Medindo as chapas</translation>
    </message>
    <message>
        <source>Drawing the plates</source>
        <translation>Desenhando as chapas</translation>
    </message>
    <message>
        <source>Four inks</source>
        <translation>Quatro tintas</translation>
    </message>
    <message>
        <source>All plates</source>
        <translation>Todas as chapas</translation>
    </message>
    <message>
        <source>Above the limit of %1 %: %2, %3 % of the inked film.
95 % of the inked film carries at most %4 %. The figures are those of the film&apos;s picture; marks and lettering are printed besides it.</source>
        <translation>Acima do limite de %1 %: %2, %3 % da película com tinta.
95 % da película com tinta leva no máximo %4 %. Os números são os da imagem da película; marcas e letras vêm à parte.</translation>
    </message>
    <message>
        <source>The sheet is printed %1 times; the figures are those of one pass.</source>
        <translation>A folha é impressa %1 vezes; os números são de uma passada.</translation>
    </message>
    <message>
        <source>%1 &gt; limit</source>
        <translation>%1 &gt; limite</translation>
    </message>
</context>
<context>
    <name>dipwright::PoseTable</name>
    <message>
        <source>%1: turned by %2° about X, Y, Z</source>
        <translation>%1: girado %2° em torno de X, Y, Z</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>≈ %1</source>
        <comment>about</comment>
        <translation>≈ %1</translation>
    </message>
    <message>
        <source>Compared with your pose: %1</source>
        <translation>Comparado com a sua pose: %1</translation>
    </message>
    <message>
        <source>Found poses, best first</source>
        <translation>Poses encontradas, a melhor primeiro</translation>
    </message>
    <message>
        <source>Verdict,
differences</source>
        <translation>Veredito,
diferenças</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>e mais %n</numerusform>
            <numerusform>e mais %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Does not meet a limit.</source>
        <translation>Não cumpre um limite.</translation>
    </message>
    <message>
        <source>Your pose.</source>
        <translation>Sua pose.</translation>
    </message>
    <message>
        <source>Better: %1</source>
        <translation>Melhor: %1</translation>
    </message>
    <message>
        <source>Worse: %1</source>
        <translation>Pior: %1</translation>
    </message>
    <message>
        <source>Objective,
coverage,
stretch</source>
        <translation>Objetivo,
cobertura,
estiramento</translation>
    </message>
    <message>
        <source>%1 (expected)</source>
        <translation>%1 (esperado)</translation>
    </message>
</context>
<context>
    <name>dipwright::PreferencesDialog</name>
    <message>
        <source>Run again after each change</source>
        <translation>Executar de novo após cada mudança</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferências</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Geral</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atalhos</translation>
    </message>
    <message>
        <source>Solvers</source>
        <translation>Solucionadores</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Polegadas</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Escuro</translation>
    </message>
    <message>
        <source>Turntable: up stays up</source>
        <translation>Mesa giratória: o alto fica no alto</translation>
    </message>
    <message>
        <source>Trackball: turns freely</source>
        <translation>Trackball: gira livremente</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navegação</translation>
    </message>
    <message>
        <source>&amp;Film of new projects</source>
        <translation>Pelíc&amp;ula de novos projetos</translation>
    </message>
    <message>
        <source>&amp;Recovery copy after</source>
        <translation>Cópia de &amp;recuperação após</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhuma</translation>
    </message>
    <message>
        <source>The language of menus, panels and messages.</source>
        <translation>O idioma de menus, painéis e mensagens.</translation>
    </message>
    <message>
        <source>The unit in which lengths and speeds are shown and typed.</source>
        <translation>A unidade em que comprimentos e velocidades são mostrados e digitados.</translation>
    </message>
    <message>
        <source>Light or dark colours.</source>
        <translation>Cores claras ou escuras.</translation>
    </message>
    <message>
        <source>&amp;Printer of new projects</source>
        <translation>I&amp;mpressora de novos projetos</translation>
    </message>
    <message>
        <source>Film pr&amp;ofile of new projects</source>
        <translation>Per&amp;fil de película de novos projetos</translation>
    </message>
    <message>
        <source>The film size proposed for new projects.</source>
        <translation>O tamanho de película proposto para novos projetos.</translation>
    </message>
    <message>
        <source>The film profile proposed for new projects.</source>
        <translation>O perfil de película proposto para novos projetos.</translation>
    </message>
    <message>
        <source>The printer profile of new projects. You can change it under Sheet.</source>
        <translation>O perfil de impressora de novos projetos. Você pode mudá-lo em Folha.</translation>
    </message>
    <message>
        <source>How dragging turns the view.</source>
        <translation>Como arrastar gira a vista.</translation>
    </message>
    <message>
        <source>Longest time between a change and the recovery copy. After a crash, your work is restored from this copy.</source>
        <translation>O maior tempo entre uma mudança e a cópia de recuperação. Após uma queda, seu trabalho é restaurado a partir desta cópia.</translation>
    </message>
    <message>
        <source>After the first run, each change recomputes the results that depend on it.</source>
        <translation>Após a primeira execução, cada mudança recalcula os resultados que dependem dela.</translation>
    </message>
    <message>
        <source>A new language takes effect when you restart the program.</source>
        <translation>Um novo idioma vale após reiniciar o programa.</translation>
    </message>
    <message>
        <source>L&amp;ength unit</source>
        <translation>Unidade de &amp;comprimento</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restaurar todos</translation>
    </message>
    <message>
        <source>%1 is assigned to both “%2” and “%3”. Change one of them.</source>
        <translation>%1 está atribuído a “%2” e a “%3”. Mude um deles.</translation>
    </message>
    <message>
        <source>Keep results next to the project file</source>
        <translation>Guardar resultados ao lado do arquivo do projeto</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Igual ao sistema</translation>
    </message>
    <message>
        <source>Saves the dips of a project in the file NAME.dips next to the project file, up to 64 MB. When you open the project again, its results are shown at once.</source>
        <translation>Salva as imersões de um projeto no arquivo NOME.dips ao lado do arquivo do projeto, até 64 MB. Quando você abre o projeto de novo, os resultados aparecem na hora.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintDialog</name>
    <message>
        <source>Custom, as set in the first project</source>
        <translation>Personalizado, como definido no primeiro projeto</translation>
    </message>
    <message>
        <source>None: true size and sRGB (choose a profile in the first project)</source>
        <translation>Nenhum: tamanho real e sRGB (escolha um perfil no primeiro projeto)</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Impressora</translation>
    </message>
    <message>
        <source>&amp;Printer</source>
        <translation>&amp;Impressora</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>&amp;Copies</source>
        <translation>&amp;Cópias</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Folhas</translation>
    </message>
    <message>
        <source>Looking for printers …</source>
        <translation>Procurando impressoras…</translation>
    </message>
    <message>
        <source>Looking for printers</source>
        <translation>Procurando impressoras</translation>
    </message>
    <message>
        <source>Choose at least one sheet.</source>
        <translation>Escolha ao menos uma folha.</translation>
    </message>
    <message>
        <source>Printing …</source>
        <translation>Imprimindo…</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Imprimindo</translation>
    </message>
    <message>
        <source>Printed on %1</source>
        <translation>Impresso em %1</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>The film itself</source>
        <translation>A própria película</translation>
    </message>
    <message>
        <source>Custom, as set under Sheet</source>
        <translation>Personalizado, como definido em Folha</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Retrato</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Paisagem</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apel</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>&amp;Orientação</translation>
    </message>
    <message>
        <source>As designed</source>
        <translation>Como projetado</translation>
    </message>
    <message>
        <source>As printed (soft proof)</source>
        <translation>Como impresso (prova virtual)</translation>
    </message>
    <message>
        <source>A soft proof needs a printer profile with an ICC profile.</source>
        <translation>A prova virtual precisa de um perfil de impressora com perfil ICC.</translation>
    </message>
    <message>
        <source>Colours of the page</source>
        <translation>Cores da página</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 gravado</translation>
    </message>
    <message>
        <source>Ready to print at true size. Pages: %1.</source>
        <translation>Pronto para imprimir em tamanho real. Páginas: %1.</translation>
    </message>
    <message>
        <source>The paper that the sheet is printed on.</source>
        <translation>O papel em que a folha é impressa.</translation>
    </message>
    <message>
        <source>Tile the sheet if the paper is too small</source>
        <translation>Dividir a folha em partes se o papel for pequeno demais</translation>
    </message>
    <message>
        <source>Print in grey on a monochrome printer</source>
        <translation>Imprimir em cinza numa impressora monocromática</translation>
    </message>
    <message>
        <source>Clip what lies outside the printable area</source>
        <translation>Cortar o que fica fora da área imprimível</translation>
    </message>
    <message>
        <source>The printer does not report this paper as loaded</source>
        <translation>A impressora não informa este papel como carregado</translation>
    </message>
    <message>
        <source>Print anyway</source>
        <translation>Imprimir mesmo assim</translation>
    </message>
    <message>
        <source>Print sheets</source>
        <translation>Imprimir folhas</translation>
    </message>
    <message>
        <source>Whether the sheet of this dip is printed.</source>
        <translation>Se a folha desta imersão é impressa.</translation>
    </message>
    <message>
        <source>Save as file…</source>
        <translation>Salvar como arquivo…</translation>
    </message>
    <message>
        <source>Saves the shown sheet as PDF or TIFF, in the printer&apos;s scale and colours.</source>
        <translation>Salva a folha mostrada como PDF ou TIFF, na escala e nas cores da impressora.</translation>
    </message>
    <message>
        <source>Number of copies of each sheet.</source>
        <translation>Número de cópias de cada folha.</translation>
    </message>
    <message>
        <source>No printer set up</source>
        <translation>Nenhuma impressora configurada</translation>
    </message>
    <message>
        <source>As printed, out-of-gamut colours in magenta</source>
        <translation>Como impresso, cores fora da gama em magenta</translation>
    </message>
    <message>
        <source>How the page is shown here. The print does not change.</source>
        <translation>Como a página é mostrada aqui. A impressão não muda.</translation>
    </message>
    <message>
        <source>Computing the soft proof</source>
        <translation>Calculando a prova virtual</translation>
    </message>
    <message>
        <source>%1 % of the painted area is out of the printer&apos;s gamut.</source>
        <translation>%1 % da área pintada está fora da gama da impressora.</translation>
    </message>
    <message>
        <source>Save sheet</source>
        <translation>Salvar folha</translation>
    </message>
    <message>
        <source>Cancelled. Pages that the printer has already begun may still come out.</source>
        <translation>Cancelado. Páginas que a impressora já começou ainda podem sair.</translation>
    </message>
    <message>
        <source>None: true size and sRGB (choose a profile under Sheet)</source>
        <translation>Nenhum: tamanho real e sRGB (escolha um perfil em Folha)</translation>
    </message>
    <message>
        <source>If this is not ticked, the program refuses a print with this problem and shows the reason.</source>
        <translation>Se não estiver marcado, o programa recusa uma impressão com este problema e mostra o motivo.</translation>
    </message>
    <message>
        <source>The printers that are set up on this computer.</source>
        <translation>As impressoras configuradas neste computador.</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. Save the sheet as PDF and print it elsewhere, at 100 %.</source>
        <translation>Não há impressora configurada neste computador. Salve a folha em PDF e imprima em outro lugar, a 100 %.</translation>
    </message>
    <message>
        <source>Checking the printer …</source>
        <translation>Verificando a impressora…</translation>
    </message>
    <message>
        <source>Checking the printer</source>
        <translation>Verificando a impressora</translation>
    </message>
    <message>
        <source>Sent to the print queue of %1</source>
        <translation>Enviado à fila de impressão de %1</translation>
    </message>
    <message>
        <source>P&amp;lates…</source>
        <translation>Cha&amp;pas…</translation>
    </message>
    <message>
        <source>This film is too long to show its plates. Look at the plates of the single jobs.</source>
        <translation>Esta película é longa demais para mostrar suas chapas. Veja as chapas dos trabalhos separados.</translation>
    </message>
    <message>
        <source>Shows the plates of the sheets, the ink under the cursor, and where there is too much ink. Needs a printer profile with an ICC profile in CMYK.</source>
        <translation>Mostra as chapas das folhas, a tinta sob o cursor e onde há tinta demais. Precisa de um perfil de impressora com perfil ICC em CMYK.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintFields</name>
    <message>
        <source>Shift X</source>
        <translation>Desvio X</translation>
    </message>
    <message>
        <source>Shift Z</source>
        <translation>Desvio Z</translation>
    </message>
    <message>
        <source>After %1 and %2</source>
        <translation>Depois de %1 e %2</translation>
    </message>
    <message>
        <source>After %1</source>
        <translation>Depois de %1</translation>
    </message>
    <message>
        <source>How far the second film is displaced along X.</source>
        <translation>Quanto a segunda película está deslocada ao longo de X.</translation>
    </message>
    <message>
        <source>How far the second film is displaced along Z.</source>
        <translation>Quanto a segunda película está deslocada ao longo de Z.</translation>
    </message>
    <message>
        <source>How much more the second film has swollen than the sheet assumes.</source>
        <translation>Quanto a segunda película inchou além do que a folha supõe.</translation>
    </message>
    <message>
        <source>Extra depth</source>
        <translation>Profundidade extra</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Redefinir</translation>
    </message>
    <message>
        <source>Puts the second film back in its intended place.</source>
        <translation>Põe a segunda película de volta no lugar previsto.</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Mostrar peça</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotação</translation>
    </message>
    <message>
        <source>Angle by which the second film is turned, from X towards Z.</source>
        <translation>Ângulo em que a segunda película está girada, de X para Z.</translation>
    </message>
    <message>
        <source>Extra swell</source>
        <translation>Inchamento extra</translation>
    </message>
    <message>
        <source>How much deeper the part is dipped. A negative value dips it less deep; surface that then stays above the water gets no ink. If the dip covers the whole part, it cannot go deeper.</source>
        <translation>Quanto mais fundo a peça é mergulhada. Com um valor negativo, ela é mergulhada menos fundo; o que então fica acima da água não recebe tinta. Se a imersão já cobre a peça inteira, ela não pode ir mais fundo.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintHistoryDialog</name>
    <message>
        <source>Project file: %1</source>
        <translation>Arquivo do projeto: %1</translation>
    </message>
    <message>
        <source>Written to: %1</source>
        <translation>Gravado em: %1</translation>
    </message>
    <message>
        <source>Film: %1</source>
        <translation>Película: %1</translation>
    </message>
    <message>
        <source>The project had not been saved when it was printed.</source>
        <translation>O projeto ainda não tinha sido salvo quando foi impresso.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Job number on the sheet, project, printer …</source>
        <translation>Número do trabalho na folha, projeto, impressora…</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabalho</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Printer or file</source>
        <translation>Impressora ou arquivo</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Cópias</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Reading the print history</source>
        <translation>Lendo o histórico de impressão</translation>
    </message>
    <message>
        <source>Reading the print history …</source>
        <translation>Lendo o histórico de impressão…</translation>
    </message>
    <message>
        <source>Nothing has been printed yet.</source>
        <translation>Nada foi impresso ainda.</translation>
    </message>
    <message>
        <source>Printer profile: %1</source>
        <translation>Perfil da impressora: %1</translation>
    </message>
    <message>
        <source>Paper name in the printer: %1</source>
        <translation>Nome do papel na impressora: %1</translation>
    </message>
    <message>
        <source>The project file no longer exists.</source>
        <translation>O arquivo do projeto não existe mais.</translation>
    </message>
    <message>
        <source>Print history</source>
        <translation>Histórico de impressão</translation>
    </message>
    <message>
        <source>Shows the prints that contain all words typed here. Parts of words are enough.</source>
        <translation>Mostra as impressões que contêm todas as palavras digitadas aqui. Partes de palavras bastam.</translation>
    </message>
    <message>
        <source>Prints, newest first</source>
        <translation>Impressões, as mais recentes primeiro</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>&amp;Open project</source>
        <translation>Abrir pro&amp;jeto</translation>
    </message>
    <message>
        <source>No print contains these words.</source>
        <translation>Nenhuma impressão contém estas palavras.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrinterColour</name>
    <message>
        <source>This ICC profile cannot be used for printing; choose the printer&apos;s output profile</source>
        <translation>Este perfil ICC não serve para imprimir; escolha o perfil de saída da impressora</translation>
    </message>
    <message>
        <source>This file is not an ICC profile, or it is damaged; choose another file</source>
        <translation>Este arquivo não é um perfil ICC ou está danificado; escolha outro arquivo</translation>
    </message>
    <message>
        <source>This ICC profile does not belong to an RGB or CMYK printer; choose the printer&apos;s output profile</source>
        <translation>Este perfil ICC não é de uma impressora RGB ou CMYK; escolha o perfil de saída da impressora</translation>
    </message>
    <message>
        <source>This file is not an ICC device link from RGB or CMYK to CMYK, or it is damaged; choose another file</source>
        <translation>Este arquivo não é um device link ICC de RGB ou CMYK para CMYK, ou está danificado; escolha outro arquivo</translation>
    </message>
</context>
<context>
    <name>dipwright::Printing</name>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper, and a part of the cut contour lies there; check that the cutter reaches it</source>
        <translation>A impressora não alcança os %1 mm externos do papel, e uma parte do contorno de corte fica ali; verifique se a máquina de corte o alcança</translation>
    </message>
    <message>
        <source>The sheet could not be sent to the printer: %1</source>
        <translation>A folha não pôde ser enviada à impressora: %1</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>The printer is stopped%1; start it again in the system&apos;s settings</source>
        <translation>A impressora está parada%1; reinicie-a nas configurações do sistema</translation>
    </message>
    <message>
        <source>The sheet of %1 is larger than every paper of the printer (%2); make it smaller or print it in tiles</source>
        <translation>A folha de %1 é maior que qualquer papel da impressora (%2); diminua-a ou imprima-a em partes</translation>
    </message>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper, and the sheet has colour there</source>
        <translation>A impressora não alcança os %1 mm externos do papel, mas a folha tem cor ali</translation>
    </message>
    <message>
        <source>The printer prints in grey only, and the sheet is coloured; choose a colour printer, or accept grey</source>
        <translation>A impressora só imprime em cinza, e a folha é colorida; escolha uma impressora em cores, ou aceite cinza</translation>
    </message>
    <message>
        <source>The printer prints the coloured sheet in grey</source>
        <translation>A impressora imprime a folha colorida em cinza</translation>
    </message>
    <message>
        <source>The printer has no paper of %1 loaded</source>
        <translation>A impressora não tem papel de %1 carregado</translation>
    </message>
    <message>
        <source>%1; load it, or choose other paper</source>
        <translation>%1; carregue-o, ou escolha outro papel</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Imprimindo</translation>
    </message>
    <message>
        <source>Held in the printer&apos;s queue</source>
        <translation>Retido na fila da impressora</translation>
    </message>
    <message>
        <source>Waiting in the printer&apos;s queue</source>
        <translation>Aguardando na fila da impressora</translation>
    </message>
    <message>
        <source>The job was cancelled at the printer</source>
        <translation>O trabalho foi cancelado na impressora</translation>
    </message>
    <message>
        <source>The sheet could not be sent to the printer</source>
        <translation>A folha não pôde ser enviada à impressora</translation>
    </message>
    <message>
        <source>Calibration of %1</source>
        <translation>Calibração de %1</translation>
    </message>
    <message>
        <source>%1, lot %2</source>
        <translation>%1, lote %2</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Impresso</translation>
    </message>
    <message>
        <source>Handed to the printer&apos;s queue</source>
        <translation>Entregue à fila da impressora</translation>
    </message>
    <message>
        <source>Written to a file</source>
        <translation>Gravado em um arquivo</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Falhou: %1</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Parado: %1</translation>
    </message>
    <message>
        <source>The printer does not report its capabilities: %1</source>
        <translation>A impressora não informa suas capacidades: %1</translation>
    </message>
    <message>
        <source>The printer refuses the job: %1</source>
        <translation>A impressora recusa o trabalho: %1</translation>
    </message>
    <message>
        <source>The print system does not report the state of the job: %1</source>
        <translation>O sistema de impressão não informa o estado do trabalho: %1</translation>
    </message>
    <message>
        <source>The cut contour is left out: it needs a PDF and a printer profile with an ICC profile in CMYK</source>
        <translation>O contorno de corte fica de fora: ele precisa de um PDF e de um perfil de impressora com um perfil ICC em CMYK</translation>
    </message>
    <message>
        <source>A sheet in tiles can only be written as PDF, one page for each tile; end the file name in .pdf</source>
        <translation>Uma folha em partes só pode ser gravada como PDF, uma página para cada parte; dê ao arquivo a extensão .pdf</translation>
    </message>
    <message>
        <source>Sent, outcome unknown</source>
        <translation>Enviado, resultado desconhecido</translation>
    </message>
    <message>
        <source>Unknown: %1</source>
        <translation>Desconhecido: %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be created</source>
        <translation>a pasta %1 não pode ser criada</translation>
    </message>
    <message>
        <source>%1; choose larger or borderless paper, or accept that this colour is lost</source>
        <translation>%1; escolha papel maior ou sem margens, ou aceite a perda dessa cor</translation>
    </message>
    <message>
        <source>The printer scales pages by itself (&quot;%1&quot;), and the print system cannot turn this off; set the scaling to &quot;none&quot; in the printer&apos;s own menu</source>
        <translation>A impressora redimensiona páginas por si (&quot;%1&quot;), e o sistema de impressão não consegue desligar isso; ponha a escala em &quot;none&quot; no menu da própria impressora</translation>
    </message>
    <message>
        <source>There is no such printer, and no other printer is set up; set one up in the system first</source>
        <translation>Essa impressora não existe, e nenhuma outra está configurada; configure uma no sistema primeiro</translation>
    </message>
    <message>
        <source>There is no such printer; choose one of: %1</source>
        <translation>Essa impressora não existe; escolha uma de: %1</translation>
    </message>
    <message>
        <source>The printer scales pages by default, and its queue cannot turn this off; the job bypasses the queue and goes directly to the printer</source>
        <translation>A impressora redimensiona páginas por padrão, e a fila não consegue desligar isso; o trabalho vai direto à impressora, sem passar pela fila</translation>
    </message>
    <message>
        <source>the job was cancelled</source>
        <translation>o trabalho foi cancelado</translation>
    </message>
    <message>
        <source>the job could not be cancelled, so remove it from the printer&apos;s queue</source>
        <translation>não foi possível cancelar o trabalho, portanto remova-o da fila da impressora</translation>
    </message>
    <message>
        <source>The print system has finished the job, but the printer does not answer; check whether the sheet was printed, and print it again if not</source>
        <translation>O sistema de impressão concluiu o trabalho, mas a impressora não responde; verifique se a folha foi impressa e, se não, imprima-a de novo</translation>
    </message>
    <message>
        <source>The printer aborted the job: %1</source>
        <translation>A impressora abortou o trabalho: %1</translation>
    </message>
    <message>
        <source>The printer stopped in the middle of the job: %1; the rest was cancelled, so print the sheet again</source>
        <translation>A impressora parou no meio do trabalho: %1; o resto foi cancelado, portanto imprima a folha de novo</translation>
    </message>
    <message>
        <source>The printer has stopped: %1; the job was cancelled, so start the printer and print the sheet again</source>
        <translation>A impressora parou: %1; o trabalho foi cancelado, portanto inicie a impressora e imprima a folha de novo</translation>
    </message>
    <message>
        <source>The printer does not answer (%1); %2; check its power, its cable and its address in the system, and print the sheet again</source>
        <translation>A impressora não responde (%1); %2; verifique a energia, o cabo e o endereço dela no sistema e imprima a folha de novo</translation>
    </message>
    <message>
        <source>The state of job %1 has not changed for a long time (%2), and this printer cannot be queried; check the printer, and remove the job from its queue if it does not print</source>
        <translation>O estado do trabalho %1 não muda há muito tempo (%2), e não é possível consultar esta impressora; verifique a impressora e remova o trabalho da fila se ela não imprimir</translation>
    </message>
    <message>
        <source>The printer refuses the job</source>
        <translation>A impressora recusa o trabalho</translation>
    </message>
    <message>
        <source>the printer would change the page size</source>
        <translation>a impressora alteraria o tamanho da página</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>nenhum motivo informado</translation>
    </message>
    <message>
        <source>The printer feeds this paper only with its other edge first; rotate the page by 90°</source>
        <translation>A impressora só aceita este papel com a outra borda primeiro; gire a página em 90°</translation>
    </message>
    <message>
        <source>%1 mm² of the part will be visibly too pale: the stretched film needs more ink there than full ink, the ink limit and the total area coverage allow</source>
        <translation>%1 mm² da peça ficarão visivelmente claros demais: ali a película esticada precisa de mais tinta do que permitem a tinta cheia, o limite de tinta e a carga total de tinta</translation>
    </message>
    <message>
        <source>This print could not be added to the print history: %1</source>
        <translation>Esta impressão não pôde ser incluída no histórico de impressão: %1</translation>
    </message>
    <message>
        <source>The printer does not accept jobs at the moment%1; allow jobs in the system&apos;s settings</source>
        <translation>A impressora não aceita trabalhos no momento%1; permita trabalhos nas configurações do sistema</translation>
    </message>
    <message>
        <source>The printer has no paper of %1; set the paper of the sheet to one of these: %2</source>
        <translation>A impressora não tem papel de %1; ajuste o papel da folha para um destes: %2</translation>
    </message>
    <message>
        <source>The printer reports no loaded paper for the tiles; load paper, or choose a paper for the tiles</source>
        <translation>A impressora não informa papel carregado para as partes da folha; carregue papel ou escolha um papel para as partes</translation>
    </message>
    <message>
        <source>The printer has no paper named %1; choose another paper</source>
        <translation>A impressora não tem papel chamado %1; escolha outro papel</translation>
    </message>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper; enter the printer&apos;s margins in its profile first</source>
        <translation>A impressora não alcança os %1 mm externos do papel; informe primeiro as margens da impressora no perfil dela</translation>
    </message>
    <message>
        <source>This version of the program cannot print; print the sheet&apos;s PDF at 100 % with another program</source>
        <translation>Esta versão do programa não imprime; imprima o PDF da folha a 100 % com outro programa</translation>
    </message>
    <message>
        <source>any size from %1 to %2</source>
        <translation>qualquer tamanho de %1 a %2</translation>
    </message>
    <message>
        <source>Each sheet must be printed %1 times onto the same film, without moving it: the project prints its ink in %1 passes</source>
        <translation>Cada folha tem de ser impressa %1 vezes na mesma película, sem movê-la: o projeto imprime a tinta em %1 passadas</translation>
    </message>
    <message>
        <source>Series on the roll, %1, with cut marks; sheets: %2</source>
        <translation>Série no rolo, %1, com marcas de corte; folhas: %2</translation>
    </message>
    <message>
        <source>At the printer profile&apos;s scale, the cut contour reaches past the edge of the paper</source>
        <translation>Na escala do perfil da impressora, o contorno de corte ultrapassa a borda do papel</translation>
    </message>
    <message>
        <source>%1; choose larger paper, or accept that a part of it is lost</source>
        <translation>%1; escolha um papel maior ou aceite que uma parte dele se perca</translation>
    </message>
    <message>
        <source>The registration marks are printed %1 mm farther inside than the pins of traveller and cradle, because this printer needs wider margins than the job&apos;s profile has. Before you use the pins, enter these margins in the profile and run the job again</source>
        <translation>As marcas de registro são impressas %1 mm mais para dentro que os pinos da ficha de acompanhamento e do berço, porque esta impressora precisa de margens maiores que as do perfil do trabalho. Antes de usar os pinos, informe essas margens no perfil e execute o trabalho de novo</translation>
    </message>
</context>
<context>
    <name>dipwright::ProfileController</name>
    <message>
        <source>Calibrated %1</source>
        <translation>%1 calibrado</translation>
    </message>
    <message>
        <source>Use profile %1</source>
        <translation>Usar o perfil %1</translation>
    </message>
</context>
<context>
    <name>dipwright::ProfilesDialog</name>
    <message>
        <source>Profiles (%1)</source>
        <translation>Perfis (%1)</translation>
    </message>
    <message>
        <source>%1 (RGB)</source>
        <translation>%1 (RGB)</translation>
    </message>
    <message>
        <source>Copy…</source>
        <translation>Copiar…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Perfis</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importar…</translation>
    </message>
    <message>
        <source>Printers</source>
        <translation>Impressoras</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Películas</translation>
    </message>
    <message>
        <source>Tanks</source>
        <translation>Tanques</translation>
    </message>
    <message>
        <source>Comes with the program</source>
        <translation>Vem com o programa</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Escolher…</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhum</translation>
    </message>
    <message>
        <source>Choose an ICC profile</source>
        <translation>Escolher um perfil ICC</translation>
    </message>
    <message>
        <source>No ICC profile</source>
        <translation>Sem perfil ICC</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>Perfil ICC</translation>
    </message>
    <message>
        <source>The printer&apos;s output profile, made for its ink and film. Sheets are then sent in the printer&apos;s own colours.</source>
        <translation>O perfil de saída da impressora, feito para sua tinta e película. As folhas são então enviadas nas cores da própria impressora.</translation>
    </message>
    <message>
        <source>A profile needs a name</source>
        <translation>Um perfil precisa de um nome</translation>
    </message>
    <message>
        <source>Name of the copy:</source>
        <translation>Nome da cópia:</translation>
    </message>
    <message>
        <source>ICC profiles (%1)</source>
        <translation>Perfis ICC (%1)</translation>
    </message>
    <message>
        <source>%1 (CMYK)</source>
        <translation>%1 (CMYK)</translation>
    </message>
    <message>
        <source>None (the printer receives sRGB)</source>
        <translation>Nenhum (a impressora recebe sRGB)</translation>
    </message>
    <message>
        <source>&amp;Use in project</source>
        <translation>&amp;Usar no projeto</translation>
    </message>
    <message>
        <source>Copies the profile and its values into the project. Later changes to the profile do not affect the project.</source>
        <translation>Copia o perfil e seus valores para o projeto. Mudanças posteriores no perfil não afetam o projeto.</translation>
    </message>
    <message>
        <source>Makes your own copy of this profile.</source>
        <translation>Cria sua própria cópia deste perfil.</translation>
    </message>
    <message>
        <source>A profile with this name already exists; choose another name</source>
        <translation>Já existe um perfil com este nome; escolha outro nome</translation>
    </message>
    <message>
        <source>Profile changed by another program</source>
        <translation>Perfil alterado por outro programa</translation>
    </message>
    <message>
        <source>Another program has changed the profile “%1” in the meantime.</source>
        <translation>Outro programa mudou o perfil “%1” nesse meio-tempo.</translation>
    </message>
    <message>
        <source>Load the other version</source>
        <translation>Carregar a outra versão</translation>
    </message>
    <message>
        <source>Keep &amp;mine</source>
        <translation>&amp;Manter o meu</translation>
    </message>
    <message>
        <source>Changes are saved at once. Profiles in italics come with the program. If you change one, your copy is used; “Remove” restores the original.</source>
        <translation>As mudanças são salvas na hora. Perfis em itálico vêm com o programa. Se você mudar um, sua cópia é usada; “Remover” restaura o original.</translation>
    </message>
    <message>
        <source>Import profile</source>
        <translation>Importar perfil</translation>
    </message>
    <message>
        <source>Export profile</source>
        <translation>Exportar perfil</translation>
    </message>
    <message>
        <source>Copy profile</source>
        <translation>Copiar perfil</translation>
    </message>
    <message>
        <source>%1, copy</source>
        <translation>%1, cópia</translation>
    </message>
    <message>
        <source>None (the ICC profile converts all pictures)</source>
        <translation>Nenhum (o perfil ICC converte todas as imagens)</translation>
    </message>
    <message>
        <source>For pictures in CMYK</source>
        <translation>Para imagens em CMYK</translation>
    </message>
    <message>
        <source>For pictures in RGB</source>
        <translation>Para imagens em RGB</translation>
    </message>
    <message>
        <source>Device link</source>
        <translation>Device link</translation>
    </message>
    <message>
        <source>An ICC device link from RGB or CMYK to the printer&apos;s CMYK. It converts pictures of its kind in place of the ICC profile, for example to keep black text in black ink. Used only with a CMYK ICC profile.</source>
        <translation>Um device link ICC de RGB ou CMYK para o CMYK da impressora. Converte imagens do seu tipo no lugar do perfil ICC, por exemplo para manter texto preto em tinta preta. Usado só com um perfil ICC CMYK.</translation>
    </message>
    <message>
        <source>Choose a device link</source>
        <translation>Escolher um device link</translation>
    </message>
    <message>
        <source>No device link</source>
        <translation>Nenhum device link</translation>
    </message>
    <message>
        <source>A device link needs the printer&apos;s ICC profile, too; choose that first</source>
        <translation>Um device link também precisa do perfil ICC da impressora; escolha-o primeiro</translation>
    </message>
</context>
<context>
    <name>dipwright::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>The result is up to date.</source>
        <translation>O resultado está atualizado.</translation>
    </message>
    <message>
        <source>Changed since the last run. Run again.</source>
        <translation>Mudou desde a última execução. Execute de novo.</translation>
    </message>
    <message>
        <source>Not simulated yet.</source>
        <translation>Ainda não simulado.</translation>
    </message>
    <message>
        <source>Add second dip</source>
        <translation>Adicionar segunda imersão</translation>
    </message>
    <message>
        <source>Remove this dip</source>
        <translation>Remover esta imersão</translation>
    </message>
</context>
<context>
    <name>dipwright::PropertyField</name>
    <message>
        <source>%1 to %2%3</source>
        <translation>%1 a %2%3</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>vinculado</translation>
    </message>
    <message>
        <source>Linked: typing one number sets the others as well</source>
        <translation>Vinculado: digitar um número define também os outros</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>Escolher %1</translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation>Escolher a cor</translation>
    </message>
</context>
<context>
    <name>dipwright::PropertyPanel</name>
    <message>
        <source>Properties</source>
        <translation>Propriedades</translation>
    </message>
    <message>
        <source>Film profile</source>
        <translation>Perfil da película</translation>
    </message>
    <message>
        <source>Tank profile</source>
        <translation>Perfil do tanque</translation>
    </message>
    <message>
        <source>Printer profile</source>
        <translation>Perfil da impressora</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Mudar %1</translation>
    </message>
    <message>
        <source>Embedded in the project</source>
        <translation>Embutido no projeto</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>Triângulos: %1</translation>
    </message>
    <message>
        <source>Volume: %1 cm³</source>
        <translation>Volume: %1 cm³</translation>
    </message>
    <message>
        <source>Closed surface</source>
        <translation>Superfície fechada</translation>
    </message>
    <message>
        <source>Surface with openings</source>
        <translation>Superfície com aberturas</translation>
    </message>
    <message>
        <source>Texture of %1 × %2 pixels</source>
        <translation>Textura de %1 × %2 pixels</translation>
    </message>
    <message>
        <source>Reads the model&apos;s file again and keeps all settings.</source>
        <translation>Lê de novo o arquivo do modelo e mantém as configurações.</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>Produção</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Predefinição</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>Escolher %1</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhum</translation>
    </message>
    <message>
        <source>Best available</source>
        <translation>Melhor disponível</translation>
    </message>
    <message>
        <source>%1 (not available)</source>
        <translation>%1 (não disponível)</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solucionador</translation>
    </message>
    <message>
        <source>%1 (not installed)</source>
        <translation>%1 (não instalado)</translation>
    </message>
    <message>
        <source>The measured values of one film: size, swell, relaxation and sides.</source>
        <translation>Os valores medidos de uma película: tamanho, inchamento, relaxação e lados.</translation>
    </message>
    <message>
        <source>The values of one tank. Its barriers hold the sides of the film.</source>
        <translation>Os valores de um tanque. Suas barreiras prendem os lados da película.</translation>
    </message>
    <message>
        <source>The measured values of one printer: scale, margins, colours, ink limit and resolution.</source>
        <translation>Os valores medidos de uma impressora: escala, margens, cores, limite de tinta e resolução.</translation>
    </message>
    <message>
        <source>No texture (drop a picture on the window to add one)</source>
        <translation>Sem textura (solte uma imagem na janela para adicionar uma)</translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>Recarregar do disco</translation>
    </message>
    <message>
        <source>Replace model…</source>
        <translation>Trocar modelo…</translation>
    </message>
    <message>
        <source>Loads another model. Rotations and offsets are reset.</source>
        <translation>Carrega outro modelo. Rotações e deslocamentos são redefinidos.</translation>
    </message>
    <message>
        <source>Replace texture…</source>
        <translation>Trocar textura…</translation>
    </message>
    <message>
        <source>Replaces the texture of the model with another picture.</source>
        <translation>Substitui a textura do modelo por outra imagem.</translation>
    </message>
    <message>
        <source>Marks for the seam</source>
        <translation>Marcas para a emenda</translation>
    </message>
    <message>
        <source>Zones on the part</source>
        <translation>Zonas na peça</translation>
    </message>
    <message>
        <source>Compute tolerances…</source>
        <translation>Calcular tolerâncias…</translation>
    </message>
    <message>
        <source>Simulates dips with the expected deviations, each alone and all at once. Shows how far the colours land from their intended places.</source>
        <translation>Simula imersões com os desvios esperados, um a um e todos juntos. Mostra a que distância do lugar previsto as cores caem.</translation>
    </message>
    <message>
        <source>Print with a misplaced second film</source>
        <translation>Impressão com a segunda película deslocada</translation>
    </message>
    <message>
        <source>Apply preset</source>
        <translation>Aplicar predefinição</translation>
    </message>
    <message>
        <source>The program that simulates the dip. “Best available” uses a GPU if there is one.</source>
        <translation>O programa que simula a imersão. “Melhor disponível” usa uma GPU, se houver.</translation>
    </message>
    <message>
        <source>Choose solver</source>
        <translation>Escolher solucionador</translation>
    </message>
    <message>
        <source>Read from %1</source>
        <translation>Lido de %1</translation>
    </message>
    <message>
        <source>Size: %1 × %2 × %3</source>
        <translation>Tamanho: %1 × %2 × %3</translation>
    </message>
    <message>
        <source>Largest dimension</source>
        <translation>Maior dimensão</translation>
    </message>
    <message>
        <source>Scales the model, with the marks on it, so that its largest dimension (along X, Y or Z) has this length.</source>
        <translation>Redimensiona o modelo, com as marcas nele, para que a maior dimensão (ao longo de X, Y ou Z) tenha este comprimento.</translation>
    </message>
    <message>
        <source>To see it, choose “Finished part” in the 3D view. The sheets do not change.</source>
        <translation>Para vê-la, escolha “Peça pronta” na vista 3D. As folhas não mudam.</translation>
    </message>
    <message>
        <source>Model of 2020</source>
        <translation>Modelo de 2020</translation>
    </message>
    <message>
        <source>Production is the accurate film model and the default. Model of 2020 is the published film model, for comparison.</source>
        <translation>Produção é o modelo de película preciso e o padrão. Modelo de 2020 é o modelo de película publicado, para comparação.</translation>
    </message>
    <message>
        <source>Change poses of path</source>
        <translation>Alterar poses do percurso</translation>
    </message>
    <message>
        <source>Masks on the part</source>
        <translation>Máscaras na peça</translation>
    </message>
    <message>
        <source>Tolerance of triangles</source>
        <translation>Tolerância dos triângulos</translation>
    </message>
    <message>
        <source>The largest distance of the triangles from the surfaces of the CAD file. A smaller one shows curves more exactly and makes more triangles. Usual: 0.005 to 0.1 mm. Zones, masks and artwork stay.</source>
        <translation>A maior distância entre os triângulos e as superfícies do arquivo CAD. Uma tolerância menor mostra curvas com mais exatidão e gera mais triângulos. Usual: 0,005 a 0,1 mm. Zonas, máscaras e arte permanecem.</translation>
    </message>
</context>
<context>
    <name>dipwright::QueueDialog</name>
    <message>
        <source>Waiting</source>
        <translation>Aguardando</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Em execução</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Concluído</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Falhou</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Projects in the queue</source>
        <translation>Projetos na fila</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Folder for the results</source>
        <translation>Pasta dos resultados</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Escolher…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1
Results: %2</source>
        <translation>%1
Resultados: %2</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duração</translation>
    </message>
    <message>
        <source>Job queue</source>
        <translation>Fila de trabalhos</translation>
    </message>
    <message>
        <source>&amp;Add projects…</source>
        <translation>&amp;Adicionar projetos…</translation>
    </message>
    <message>
        <source>&amp;Cancel selected</source>
        <translation>&amp;Cancelar selecionados</translation>
    </message>
    <message>
        <source>Cancel a&amp;ll</source>
        <translation>Cancelar &amp;todos</translation>
    </message>
    <message>
        <source>&amp;Remove finished</source>
        <translation>&amp;Remover terminados</translation>
    </message>
    <message>
        <source>&amp;Open project</source>
        <translation>Abrir pro&amp;jeto</translation>
    </message>
    <message>
        <source>Each added project gets a subfolder with its name here.</source>
        <translation>Cada projeto adicionado recebe aqui uma subpasta com seu nome.</translation>
    </message>
    <message>
        <source>Resul&amp;ts folder</source>
        <translation>Pa&amp;sta dos resultados</translation>
    </message>
    <message>
        <source>Add projects</source>
        <translation>Adicionar projetos</translation>
    </message>
    <message>
        <source>%1 of %2 finished</source>
        <translation>%1 de %2 terminados</translation>
    </message>
    <message>
        <source>Projects are still running. Stop them?</source>
        <translation>Ainda há projetos em execução. Parar?</translation>
    </message>
    <message>
        <source>Finished results are kept.</source>
        <translation>Os resultados concluídos são mantidos.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Parar</translation>
    </message>
    <message>
        <source>Add projects. They run one after the other, each in its last saved version. The results are written to the results folder.</source>
        <translation>Adicione projetos. Eles são executados um após o outro, cada um na última versão salva. Os resultados são gravados na pasta dos resultados.</translation>
    </message>
    <message>
        <source>Result of the selected project</source>
        <translation>Resultado do projeto selecionado</translation>
    </message>
    <message>
        <source>At the tan&amp;k…</source>
        <translation>No tan&amp;que…</translation>
    </message>
    <message>
        <source>Opens the tank-side page with the steps of all finished projects</source>
        <translation>Abre a página do tanque com os passos de todos os projetos prontos</translation>
    </message>
</context>
<context>
    <name>dipwright::ReadPhotos</name>
    <message>
        <source>The photo cannot be read; check its name and permissions</source>
        <translation>A foto não pode ser lida; verifique o nome e as permissões</translation>
    </message>
</context>
<context>
    <name>dipwright::Reader</name>
    <message>
        <source>This operating system cannot run the reader of models and pictures in a sandbox, so nothing was read. Use another system, or set DIPWRIGHT_READ_UNCONFINED=1 for files that you trust</source>
        <translation>Este sistema operacional não consegue executar numa sandbox o programa que lê modelos e imagens; por isso nada foi lido. Use outro sistema ou defina DIPWRIGHT_READ_UNCONFINED=1 para arquivos em que você confia</translation>
    </message>
</context>
<context>
    <name>dipwright::ReaderProcess</name>
    <message>
        <source>The program that reads models and pictures cannot be started: %1</source>
        <translation>O programa que lê modelos e imagens não pode ser iniciado: %1</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of the language of this translation: de, pt_BR …</extracomment>
        <translation>pt_BR</translation>
    </message>
    <message>
        <source>The program that reads models and pictures is missing; reinstall Dipwright</source>
        <translation>O programa que lê modelos e imagens está faltando; reinstale o Dipwright</translation>
    </message>
    <message>
        <source>The file was not read, because the file reader returned invalid data for it; save it again</source>
        <translation>O arquivo não foi lido, porque o leitor devolveu dados inválidos para ele; salve-o de novo</translation>
    </message>
    <message>
        <source>The file was not read, because it made the file reader crash; save it again (a model as %1, a picture as PNG)</source>
        <translation>O arquivo não foi lido, porque fez o leitor falhar; salve-o de novo (um modelo como %1, uma imagem como PNG)</translation>
    </message>
    <message>
        <source>This Dipwright was built without the reader of CAD files; save the model as %1, or use a Dipwright with CAD (dipwright-cad-reader)</source>
        <translation>Este Dipwright foi compilado sem o leitor de arquivos CAD; salve o modelo como %1 ou use um Dipwright com CAD (dipwright-cad-reader)</translation>
    </message>
    <message>
        <source>The CAD file was not read, because it made the file reader crash; save it again as STEP (AP214 or AP242) in the CAD program</source>
        <translation>O arquivo CAD não foi lido, porque fez o leitor falhar; salve-o de novo como STEP (AP214 ou AP242) no programa CAD</translation>
    </message>
</context>
<context>
    <name>dipwright::ReplaceQuestion</name>
    <message>
        <source>%1 already contains %2. Replace them?</source>
        <translation>%1 já contém %2. Substituir?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Substituir</translation>
    </message>
</context>
<context>
    <name>dipwright::ReportPanel</name>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>Run the dip to see its figures.</source>
        <translation>Execute a imersão para ver seus números.</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solucionador</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Dispositivo</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerâncias</translation>
    </message>
    <message>
        <source>Film used</source>
        <translation>Película usada</translation>
    </message>
    <message>
        <source>Total coverage</source>
        <translation>Cobertura total</translation>
    </message>
    <message>
        <source>Masked areas</source>
        <translation>Áreas mascaradas</translation>
    </message>
</context>
<context>
    <name>dipwright::ResultTabs</name>
    <message>
        <source>Changed since the last run. Run again.</source>
        <translation>Mudou desde a última execução. Execute de novo.</translation>
    </message>
    <message>
        <source>%1, out of date</source>
        <translation>%1, desatualizado</translation>
    </message>
</context>
<context>
    <name>dipwright::Results</name>
    <message>
        <source>Dark outline: film on the part · grey: unused film</source>
        <translation>Contorno escuro: película na peça · cinza: película não usada</translation>
    </message>
    <message>
        <source>There is no colour map of this name; choose one of %1</source>
        <translation>Não há mapa de cores com este nome; escolha um de %1</translation>
    </message>
    <message>
        <source>Preparing the proof</source>
        <translation>Preparando a prova</translation>
    </message>
    <message>
        <source>Drawing the proof</source>
        <translation>Desenhando a prova</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Trás</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Stretch of the film</source>
        <translation>Estiramento da película</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>stretch
mm per mm</source>
        <translation>estiramento
mm por mm</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 e mais</translation>
    </message>
    <message>
        <source>Wrinkling of the film</source>
        <translation>Enrugamento da película</translation>
    </message>
    <message>
        <source>Smaller principal stretch; below 1 the film is compressed and may fold</source>
        <translation>Menor estiramento principal; abaixo de 1 a película está comprimida e pode dobrar</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mais</translation>
    </message>
    <message>
        <source>%1: %2 mm², %3 %</source>
        <translation>%1: %2 mm², %3 %</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>De cima</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>De baixo</translation>
    </message>
    <message>
        <source>Film of %1</source>
        <translation>Película de %1</translation>
    </message>
    <message>
        <source>Tolerance of the sheet</source>
        <translation>Tolerância da folha</translation>
    </message>
    <message>
        <source>in</source>
        <translation>pol</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>a number and its unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Both, in the overlap</source>
        <translation>Ambas, na sobreposição</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Não pintado</translation>
    </message>
    <message>
        <source>Seam: %1 mm</source>
        <translation>Emenda: %1 mm</translation>
    </message>
    <message>
        <source>Drawing the coverage picture</source>
        <translation>Desenhando a imagem de cobertura</translation>
    </message>
    <message>
        <source>Stretch of the film on the part: min. %1 · mean %2 · 95 % below %3 · max. %4</source>
        <translation>Estiramento da película na peça: mín. %1 · média %2 · 95 % abaixo de %3 · máx. %4</translation>
    </message>
    <message>
        <source>On the part: %1 % of the film is compressed by over 1 % · smallest stretch %2</source>
        <translation>Na peça: %1 % da película estão comprimidos em mais de 1 % · menor estiramento %2</translation>
    </message>
    <message>
        <source>Numerical error of the sheet</source>
        <translation>Erro numérico da folha</translation>
    </message>
    <message>
        <source>error
%1</source>
        <translation>erro
%1</translation>
    </message>
    <message>
        <source>How far handling may move the image on the part; ink side up</source>
        <translation>Quanto o manuseio pode deslocar a imagem na peça; lado da tinta para cima</translation>
    </message>
    <message>
        <source>shift
± %1</source>
        <translation>desvio
± %1</translation>
    </message>
    <message>
        <source>Dark outline: film on the part · pale: unused film</source>
        <translation>Contorno escuro: película na peça · claro: película não usada</translation>
    </message>
    <message>
        <source>How far the image may be off because of the film&apos;s cells and the solver&apos;s steps; ink side up</source>
        <translation>Quanto a imagem pode se desviar por causa das células da película e dos passos do solucionador; lado da tinta para cima</translation>
    </message>
    <message>
        <source>Mean stretch at each point: final length divided by rest length; ink side up</source>
        <translation>Estiramento médio em cada ponto: comprimento final dividido pelo de repouso; lado da tinta para cima</translation>
    </message>
    <message>
        <source>On the part: 95 % of the image moves by ±%1 or less</source>
        <translation>Na peça: 95 % da imagem se deslocam no máximo ±%1</translation>
    </message>
    <message>
        <source>Limit: %1 · black: painted by only one of the compared dips</source>
        <translation>Limite: %1 · preto: pintado por só uma das imersões comparadas</translation>
    </message>
    <message>
        <source>Difference of two sheets</source>
        <translation>Diferença de duas folhas</translation>
    </message>
    <message>
        <source>How far the image is from its place on the other sheet; ink side up</source>
        <translation>Quanto a imagem está longe do seu lugar na outra folha; lado da tinta para cima</translation>
    </message>
    <message>
        <source>distance
%1</source>
        <translation>distância
%1</translation>
    </message>
    <message>
        <source>Black: painted in only one of the two states</source>
        <translation>Preto: pintado em só um dos dois estados</translation>
    </message>
</context>
<context>
    <name>dipwright::ResultsPanel</name>
    <message>
        <source>Reverse texture</source>
        <translation>Textura reversa</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Prova</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Folha</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramento</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>How much the film has stretched, and where</source>
        <translation>Quanto a película esticou e onde</translation>
    </message>
    <message>
        <source>The figures of the last run</source>
        <translation>Os números da última execução</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredito</translation>
    </message>
    <message>
        <source>Run the dip to see the image for the film.</source>
        <translation>Execute a imersão para ver a imagem para a película.</translation>
    </message>
    <message>
        <source>Run the dip to see the finished part.</source>
        <translation>Execute a imersão para ver a peça pronta.</translation>
    </message>
    <message>
        <source>Run the dip to see the page as it will be printed.</source>
        <translation>Execute a imersão para ver a página como será impressa.</translation>
    </message>
    <message>
        <source>Shares of the dips</source>
        <translation>Partes das imersões</translation>
    </message>
    <message>
        <source>Shows which areas each dip paints, from six sides and on both films</source>
        <translation>Mostra quais áreas cada imersão pinta, de seis lados e nas duas películas</translation>
    </message>
    <message>
        <source>Shows which areas each dip paints, over the sheet of this dip</source>
        <translation>Mostra quais áreas cada imersão pinta, sobre a folha desta imersão</translation>
    </message>
    <message>
        <source>Without white</source>
        <translation>Sem branco</translation>
    </message>
    <message>
        <source>Shows the ink on the part&apos;s own colour, without the white</source>
        <translation>Mostra a tinta sobre a cor da própria peça, sem o branco</translation>
    </message>
    <message>
        <source>Whether to print the sheet, and which places to check first</source>
        <translation>Se a folha deve ser impressa e quais lugares verificar primeiro</translation>
    </message>
    <message>
        <source>The reverse texture: the image for the film</source>
        <translation>A textura reversa: a imagem para a película</translation>
    </message>
    <message>
        <source>The finished part</source>
        <translation>A peça pronta</translation>
    </message>
    <message>
        <source>The page as it will be printed</source>
        <translation>A página como será impressa</translation>
    </message>
</context>
<context>
    <name>dipwright::ReverseTexture</name>
    <message>
        <source>Reversing the texture</source>
        <translation>Revertendo a textura</translation>
    </message>
    <message>
        <source>The film image is too large for this computer&apos;s memory; choose a lower resolution</source>
        <translation>A imagem da película é grande demais para a memória deste computador; escolha uma resolução menor</translation>
    </message>
    <message>
        <source>Adding bleed at the edges</source>
        <translation>Acrescentando a sangria nas bordas</translation>
    </message>
</context>
<context>
    <name>dipwright::SeamFields</name>
    <message>
        <source>Whole face</source>
        <translation>Face inteira</translation>
    </message>
    <message>
        <source>Keeps the seam away</source>
        <translation>Afasta a emenda</translation>
    </message>
    <message>
        <source>Allows the seam</source>
        <translation>Permite a emenda</translation>
    </message>
    <message>
        <source>Marks the whole flat face that you click, up to its edges.</source>
        <translation>Marca toda a face plana em que você clica, até as suas arestas.</translation>
    </message>
    <message>
        <source>Assigns the place to %1</source>
        <translation>Atribui o lugar a %1</translation>
    </message>
    <message>
        <source>What a click or drag on the part does. Assign areas to the other dip to move the seam. With “Run live” the seam is updated at once.</source>
        <translation>O que um clique ou arrasto na peça faz. Atribua áreas à outra imersão para mover a emenda. Com “Executar ao vivo” a emenda é atualizada na hora.</translation>
    </message>
</context>
<context>
    <name>dipwright::SearchController</name>
    <message>
        <source>Searching poses</source>
        <translation>Procurando poses</translation>
    </message>
    <message>
        <source>The search has finished. The best pose is at the top.</source>
        <translation>A busca terminou. A melhor pose está no alto.</translation>
    </message>
    <message>
        <source>The search was stopped. The best pose so far is at the top.</source>
        <translation>A busca foi interrompida. A melhor pose até agora está no alto.</translation>
    </message>
    <message>
        <source>Pose search</source>
        <translation>Busca de poses</translation>
    </message>
    <message>
        <source>Change search settings</source>
        <translation>Alterar configurações da busca</translation>
    </message>
</context>
<context>
    <name>dipwright::SearchPage</name>
    <message>
        <source>&amp;Search</source>
        <translation>&amp;Procurar</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Encerrar</translation>
    </message>
    <message>
        <source>One dip</source>
        <translation>Uma imersão</translation>
    </message>
    <message>
        <source>Two dips, judged together</source>
        <translation>Duas imersões, julgadas juntas</translation>
    </message>
    <message>
        <source> poses</source>
        <translation> poses</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Progresso da busca</translation>
    </message>
    <message>
        <source>%1 of %2 dips</source>
        <translation>%1 de %2 imersões</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Colocação %1</translation>
    </message>
    <message>
        <source>&amp;Use this pose</source>
        <translation>&amp;Usar esta pose</translation>
    </message>
    <message>
        <source>Side &amp;by side…</source>
        <translation>La&amp;do a lado…</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Imersões</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simular</translation>
    </message>
    <message>
        <source>Weights and limits</source>
        <translation>Pesos e limites</translation>
    </message>
    <message>
        <source>Leaves the processor to other programs. The search continues where it stopped.</source>
        <translation>Deixa o processador para outros programas. A busca continua de onde parou.</translation>
    </message>
    <message>
        <source>Ends the search and keeps the best poses found</source>
        <translation>Encerra a busca e guarda as melhores poses encontradas</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Retomar</translation>
    </message>
    <message>
        <source>Rank %1 compared with rank %2: %3</source>
        <translation>Colocação %1 comparada com a colocação %2: %3</translation>
    </message>
    <message>
        <source>The project&apos;s own pose</source>
        <translation>A pose do projeto</translation>
    </message>
    <message>
        <source>Number of poses that are simulated with a coarse film. They are chosen from %1 poses that are judged by the part&apos;s shape alone. The best simulated poses are refined.</source>
        <translation>Número de poses simuladas com uma película grosseira. São escolhidas entre %1 poses avaliadas só pela forma da peça. As melhores poses simuladas são refinadas.</translation>
    </message>
    <message>
        <source>The same seed gives the same table. Another seed tries other directions.</source>
        <translation>A mesma semente dá a mesma tabela. Outra semente experimenta outras direções.</translation>
    </message>
    <message>
        <source>Shows two selected poses side by side with linked cameras. If only one pose is selected, shows it beside the project&apos;s own pose.</source>
        <translation>Mostra duas poses selecionadas lado a lado com câmeras ligadas. Se só uma pose está selecionada, mostra-a ao lado da pose do projeto.</translation>
    </message>
    <message>
        <source>Click a pose to see its film on the part, also during the search. Undo brings back your own pose. Select two poses to compare them.</source>
        <translation>Clique em uma pose para ver a película dela na peça, também durante a busca. Desfazer traz de volta a sua pose. Selecione duas poses para compará-las.</translation>
    </message>
    <message>
        <source>Sets the dips of the project to the pose that is selected in the table. Undo takes this back in one step.</source>
        <translation>Põe as imersões do projeto na pose selecionada na tabela. Desfazer reverte isso em um só passo.</translation>
    </message>
    <message>
        <source>Waiting until the dip of the project has finished</source>
        <translation>Aguardando o fim da imersão do projeto</translation>
    </message>
    <message>
        <source>Try paths</source>
        <translation>Tentar percursos</translation>
    </message>
    <message>
        <source>Also tries paths for the best poses: the part enters the water tilted and is levelled on the way down, goes down slanted, or, if a depth is set, rolls. So air can escape, and the film reaches further. Takes about twice as long.</source>
        <translation>Tenta também percursos para as melhores poses: a peça entra tombada na água e é nivelada na descida, desce inclinada ou, se uma profundidade está definida, rola. Assim o ar pode escapar, e a película alcança mais longe. Demora cerca do dobro.</translation>
    </message>
    <message>
        <source>Whether one dip paints the part, or two dips from different sides.</source>
        <translation>Se uma imersão pinta a peça, ou duas de lados diferentes.</translation>
    </message>
    <message>
        <source>Dipping the best pose with smaller cells</source>
        <translation>Mergulhando a melhor pose com células menores</translation>
    </message>
    <message>
        <source>The project has changed since this search. Search again.</source>
        <translation>O projeto mudou desde esta busca. Busque de novo.</translation>
    </message>
</context>
<context>
    <name>dipwright::ServerController</name>
    <message>
        <source>Running on the server</source>
        <translation>Executando no servidor</translation>
    </message>
    <message>
        <source>The project was changed while the server ran it. Send it again.</source>
        <translation>O projeto foi alterado enquanto o servidor o executava. Envie-o de novo.</translation>
    </message>
    <message>
        <source>The server has simulated the dips.</source>
        <translation>O servidor simulou as imersões.</translation>
    </message>
    <message>
        <source>Send to server</source>
        <translation>Enviar ao servidor</translation>
    </message>
</context>
<context>
    <name>dipwright::ServerDialog</name>
    <message>
        <source>Paste the server&apos;s token, or write the path of its file</source>
        <translation>Cole o token do servidor, ou escreva o caminho do arquivo dele</translation>
    </message>
    <message>
        <source>Send to server</source>
        <translation>Enviar ao servidor</translation>
    </message>
    <message>
        <source>Where dipwright-cli serve listens: a port of this computer, such as 127.0.0.1:8137, or the path of a socket. Another computer is reached through an SSH tunnel.</source>
        <translation>Onde dipwright-cli serve escuta: uma porta deste computador, como 127.0.0.1:8137, ou o caminho de um socket. Outro computador é alcançado por um túnel SSH.</translation>
    </message>
    <message>
        <source>The token that the server asks for, or the path of the file that holds it. Only the path is remembered.</source>
        <translation>O token que o servidor pede, ou o caminho do arquivo que o contém. Só o caminho é lembrado.</translation>
    </message>
    <message>
        <source>The server simulates the dips of this project. Its results then appear here like those of a run on this computer.</source>
        <translation>O servidor simula as imersões deste projeto. Os resultados aparecem aqui como os de uma execução neste computador.</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Endereço</translation>
    </message>
    <message>
        <source>&amp;Token or its file</source>
        <translation>&amp;Token ou o arquivo dele</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>E&amp;nviar</translation>
    </message>
    <message>
        <source>There is no such file</source>
        <translation>Este arquivo não existe</translation>
    </message>
</context>
<context>
    <name>dipwright::Sheet</name>
    <message>
        <source>The cut contour with its bleed reaches %1 mm from the ink, past the edge of this job&apos;s sheet; choose a smaller distance or bleed, or a cut contour along the film&apos;s edge</source>
        <translation>O contorno de corte com sua sangria vai %1 mm além da tinta e ultrapassa a borda da folha deste trabalho; escolha uma distância ou sangria menor, ou um contorno de corte pela borda da película</translation>
    </message>
    <message>
        <source>The setting “%1” differs between this job and %2; give both the same value</source>
        <translation>A configuração “%1” difere entre este trabalho e %2; dê a ambos o mesmo valor</translation>
    </message>
    <message>
        <source>Bleed at the cut contour</source>
        <translation>Sangria no contorno de corte</translation>
    </message>
    <message>
        <source>Distance of the cut contour</source>
        <translation>Distância do contorno de corte</translation>
    </message>
    <message>
        <source>Name of the cut contour</source>
        <translation>Nome do contorno de corte</translation>
    </message>
    <message>
        <source>Cut contour</source>
        <translation>Contorno de corte</translation>
    </message>
    <message>
        <source>With its marks, this job&apos;s sheet needs %1 × %2 mm, but the roll has only %3 × %4 mm inside its edges; use a larger roll or a smaller film</source>
        <translation>Com suas marcas, a folha deste trabalho precisa de %1 × %2 mm, mas o rolo só tem %3 × %4 mm dentro de suas bordas; use um rolo maior ou uma película menor</translation>
    </message>
    <message>
        <source>The sheet&apos;s PDF cannot be written: %1</source>
        <translation>O PDF da folha não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>The sheet&apos;s TIFF cannot be written: %1</source>
        <translation>O TIFF da folha não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Unknown paper &quot;%1&quot;; choose film, A4, A3, Letter or custom</source>
        <translation>Papel “%1” desconhecido; escolha film, A4, A3, Letter ou custom</translation>
    </message>
    <message>
        <source>The paper of %1 × %2 mm is smaller than the film of %3 × %4 mm; choose larger paper, turn it or make the film smaller</source>
        <translation>O papel de %1 × %2 mm é menor que a película de %3 × %4 mm; escolha papel maior, gire-o ou diminua a película</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Trabalho %1</translation>
    </message>
    <message>
        <source>Dip %1, copy %2 of %3</source>
        <translation>Imersão %1, cópia %2 de %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · Film %4 · Scale %5</source>
        <translation>%1 · %2 · %3 · Película %4 · Escala %5</translation>
    </message>
    <message>
        <source>This job&apos;s sheet has %1 dpi, but the sheet of %2 has %3 dpi; give both the same resolution</source>
        <translation>A folha deste trabalho tem %1 dpi, mas a folha de %2 tem %3 dpi; dê a ambas a mesma resolução</translation>
    </message>
    <message>
        <source>%1 pieces cannot be packed; choose 1 to %2 pieces</source>
        <translation>%1 pedaços não podem ser agrupados; escolha de 1 a %2 pedaços</translation>
    </message>
    <message>
        <source>With its marks, this job&apos;s sheet needs %1 × %2 mm, but the film has only %3 × %4 mm inside its edges; use a larger film</source>
        <translation>Com suas marcas, a folha deste trabalho precisa de %1 × %2 mm, mas a película só tem %3 × %4 mm dentro de suas bordas; use uma película maior</translation>
    </message>
    <message>
        <source>The copies need %1 films, more than the limit of %2; choose fewer copies</source>
        <translation>As cópias precisam de %1 películas, mais que o limite de %2; escolha menos cópias</translation>
    </message>
    <message>
        <source>A film of %1 × %2 mm at %3 dpi needs an image outside the range of 1 to %4 pixels per side; choose another resolution or film size</source>
        <translation>Uma película de %1 × %2 mm a %3 dpi exige uma imagem fora da faixa de 1 a %4 pixels por lado; escolha outra resolução ou tamanho de película</translation>
    </message>
    <message>
        <source>The sheet&apos;s PNG cannot be written: %1</source>
        <translation>Não foi possível gravar o PNG da folha: %1</translation>
    </message>
    <message>
        <source>The sheet needs more than %1 pages of this paper; use larger paper</source>
        <translation>A folha precisa de mais de %1 páginas deste papel; use papel maior</translation>
    </message>
    <message>
        <source>This job&apos;s spot ink %1 has another colour or printing order than in another job; give it the same colour and order in both jobs</source>
        <translation>A tinta especial %1 tem neste trabalho outra cor ou ordem de impressão que em outro trabalho; dê a ela a mesma cor e ordem nos dois trabalhos</translation>
    </message>
    <message>
        <source>This job&apos;s white layer differs from the white layer of %1; give both the same kind of white and the same ink name</source>
        <translation>A camada de branco deste trabalho difere da camada de branco de %1; dê a ambas o mesmo tipo de branco e o mesmo nome de tinta</translation>
    </message>
    <message>
        <source>This job&apos;s sheet contains no ink; remove the job from the film</source>
        <translation>A folha deste trabalho não contém tinta; remova o trabalho da película</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small for a tile of the sheet; use larger paper</source>
        <translation>Papel de %1 × %2 mm é pequeno demais para uma parte da folha; use papel maior</translation>
    </message>
    <message>
        <source>Film %1 of %2, 1 piece</source>
        <translation>Película %1 de %2, 1 pedaço</translation>
    </message>
    <message>
        <source>Film %1 of %2, %3 pieces</source>
        <translation>Película %1 de %2, %3 pedaços</translation>
    </message>
    <message>
        <source>Film %1 · Scale %2 · %3</source>
        <translation>Película %1 · Escala %2 · %3</translation>
    </message>
    <message>
        <source>A film of %1 mm is longer than the limit of %2 mm; choose a shorter film</source>
        <translation>Uma película de %1 mm é mais longa que o limite de %2 mm; escolha uma película mais curta</translation>
    </message>
    <message>
        <source>Job %1 · %2 · copy %3 of %4</source>
        <translation>Trabalho %1 · %2 · cópia %3 de %4</translation>
    </message>
    <message>
        <source>This job&apos;s sheet is printed in %1 passes, but the sheet of %2 in %3; give both the same number of passes</source>
        <translation>A folha deste trabalho é impressa em %1 passadas, mas a folha de %2 em %3; dê a ambas o mesmo número de passadas</translation>
    </message>
    <message>
        <source>Row %2 of %3, column %4 of %5 · job %1 · %6 · %7 · cut along the dashed lines</source>
        <translation>Linha %2 de %3, coluna %4 de %5 · trabalho %1 · %6 · %7 · corte ao longo das linhas tracejadas</translation>
    </message>
    <message>
        <source>The marks, the ruler or the job line cover a part of the picture, because there is no room beside it. Use larger film or paper, or do not print them</source>
        <translation>As marcas, a régua ou a linha do trabalho cobrem uma parte da imagem, porque não há espaço ao lado dela. Use película ou papel maior, ou não as imprima</translation>
    </message>
    <message>
        <source>The ink %1 is a spot ink in one job and the white ink in another; rename one of them</source>
        <translation>A tinta %1 é uma tinta especial em um trabalho e o branco em outro; renomeie uma delas</translation>
    </message>
    <message>
        <source>This job&apos;s spot ink %1 is named %2 in another job; write both alike, with the same capital letters</source>
        <translation>A tinta especial %1 deste trabalho chama-se %2 em outro; escreva as duas da mesma forma, com as mesmas maiúsculas</translation>
    </message>
</context>
<context>
    <name>dipwright::SheetCorrection</name>
    <message>
        <source>Dip %1: %2 places measured on one part, errors up to %3 mm. Measure three parts or more to see which errors repeat.</source>
        <translation>Imersão %1: %2 lugares medidos em uma peça, erros de até %3 mm. Meça três peças ou mais para ver quais erros se repetem.</translation>
    </message>
    <message>
        <source>Blue: correction of the next sheet, to the same scale</source>
        <translation>Azul: correção da próxima folha, na mesma escala</translation>
    </message>
    <message>
        <source>Dip %1: %2 places measured on %3 parts. The repeating error is up to %4 mm; places less than %5 mm apart have similar errors. Scatter: %6 mm for single places, %7 mm for whole parts.</source>
        <translation>Imersão %1: %2 lugares medidos em %3 peças. O erro que se repete é de até %4 mm; lugares a menos de %5 mm um do outro têm erros semelhantes. Dispersão: %6 mm em lugares isolados, %7 mm em peças inteiras.</translation>
    </message>
    <message>
        <source>The measured errors of dip %1 contradict each other, so a correction would fold or mirror the sheet; check the measured places, or remove the part from the job or turn the correction off</source>
        <translation>Os erros medidos da imersão %1 se contradizem, e uma correção dobraria ou espelharia a folha; verifique os pontos medidos, remova a peça do trabalho ou desative a correção</translation>
    </message>
    <message>
        <source>The measured parts move the picture by up to %1 mm and change lengths by %2 %. More than %3 mm or %4 % is unusual. Check the measured places, or turn the correction off.</source>
        <translation>As peças medidas deslocam a imagem em até %1 mm e alteram comprimentos em %2 %. Mais de %3 mm ou %4 % é incomum. Verifique os pontos medidos ou desative a correção.</translation>
    </message>
    <message>
        <source>Red: mean measured error (parts: %1), scale %2:1</source>
        <translation>Vermelho: erro médio medido (peças: %1), escala %2:1</translation>
    </message>
</context>
<context>
    <name>dipwright::SnapshotsDialog</name>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remover</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Instantâneos</translation>
    </message>
    <message>
        <source>Name of the snapshot</source>
        <translation>Nome do instantâneo</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Comparado com</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Comparado com %1</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Configuração</translation>
    </message>
    <message>
        <source>All settings are the same.</source>
        <translation>Todas as configurações são iguais.</translation>
    </message>
    <message>
        <source>Settings that differ: %1</source>
        <translation>Configurações que diferem: %1</translation>
    </message>
    <message>
        <source>&amp;Take snapshot</source>
        <translation>&amp;Tirar instantâneo</translation>
    </message>
    <message>
        <source>R&amp;estore</source>
        <translation>R&amp;estaurar</translation>
    </message>
    <message>
        <source>&amp;Side by side…</source>
        <translation>&amp;Lado a lado…</translation>
    </message>
    <message>
        <source>Snapshots, oldest first</source>
        <translation>Instantâneos, os mais antigos primeiro</translation>
    </message>
    <message>
        <source>The name under which the settings are saved in the project file</source>
        <translation>O nome com que as configurações são salvas no arquivo do projeto</translation>
    </message>
    <message>
        <source>Restores the settings of the snapshot. Model, photos and measured parts stay. This can be undone.</source>
        <translation>Restaura as configurações do instantâneo. Modelo, fotos e peças medidas ficam. Isso pode ser desfeito.</translation>
    </message>
    <message>
        <source>Compared with the current project</source>
        <translation>Comparado com o projeto atual</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Atual</translation>
    </message>
    <message>
        <source>A snapshot saves the project&apos;s settings under a name in the project file.</source>
        <translation>Um instantâneo salva as configurações do projeto com um nome no arquivo do projeto.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Diferenças</translation>
    </message>
    <message>
        <source>Shows both versions side by side in linked views. Dips that have no result yet are run first.</source>
        <translation>Mostra as duas versões lado a lado em vistas ligadas. As imersões ainda sem resultado são executadas antes.</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Instantâneo</translation>
    </message>
</context>
<context>
    <name>dipwright::SolverPage</name>
    <message>
        <source>Solvers</source>
        <translation>Solucionadores</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solucionador</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versão</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Dispositivo</translation>
    </message>
    <message>
        <source>%1 by %2
%3</source>
        <translation>%1 de %2
%3</translation>
    </message>
    <message>
        <source>Put solver plugins into %1</source>
        <translation>Ponha plugins de solucionador em %1</translation>
    </message>
    <message>
        <source>Choose the solver of a project under Dipping. “Best available” uses the best solver that can run on this computer.</source>
        <translation>Escolha o solucionador de um projeto em Imersão. “Melhor disponível” usa o melhor que possa rodar neste computador.</translation>
    </message>
    <message>
        <source>No solver found</source>
        <translation>Nenhum solucionador encontrado</translation>
    </message>
    <message>
        <source>Checking whether this solver can run here …</source>
        <translation>Verificando se este solucionador pode rodar aqui…</translation>
    </message>
</context>
<context>
    <name>dipwright::StartPage</name>
    <message>
        <source>Recent projects</source>
        <translation>Projetos recentes</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemplos</translation>
    </message>
    <message>
        <source>Projects that you open or save appear here.</source>
        <translation>Projetos que você abrir ou salvar aparecem aqui.</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Remover desta lista</translation>
    </message>
    <message>
        <source>Models and projects can also be dropped on the window.</source>
        <translation>Modelos e projetos também podem ser soltos na janela.</translation>
    </message>
    <message>
        <source>Start from a textured model: %1.</source>
        <translation>Comece de um modelo texturizado: %1.</translation>
    </message>
    <message>
        <source>From a textured model to a printable film.</source>
        <translation>Do modelo texturizado à película pronta para imprimir.</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Novo projeto…</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Abrir projeto…</translation>
    </message>
    <message>
        <source>Continue with a saved project.</source>
        <translation>Continue um projeto salvo.</translation>
    </message>
    <message>
        <source>Quick tour</source>
        <translation>Visita rápida</translation>
    </message>
    <message>
        <source>Explains the window in six steps.</source>
        <translation>Explica a janela em seis passos.</translation>
    </message>
</context>
<context>
    <name>dipwright::StatusLine</name>
    <message>
        <source>Value under the cursor</source>
        <translation>Valor sob o cursor</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>The job does not respond. Save your work, then close the window to end the job.</source>
        <translation>O trabalho não responde. Salve seu trabalho e feche a janela para encerrá-lo.</translation>
    </message>
    <message>
        <source>Cancel saving</source>
        <translation>Cancelar o salvamento</translation>
    </message>
    <message>
        <source>Cancel saving. The file stays as it was.</source>
        <translation>Cancelar o salvamento. O arquivo fica como estava.</translation>
    </message>
</context>
<context>
    <name>dipwright::StretchPanel</name>
    <message>
        <source>Automatic range</source>
        <translation>Faixa automática</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Menor valor</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Maior valor</translation>
    </message>
    <message>
        <source>Mark above</source>
        <translation>Marcar acima de</translation>
    </message>
    <message>
        <source>Limit above which film is marked</source>
        <translation>Limite acima do qual a película é marcada</translation>
    </message>
    <message>
        <source>Isolines</source>
        <translation>Isolinhas</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramento</translation>
    </message>
    <message>
        <source>Area stretch</source>
        <translation>Estiramento de área</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Maior estiramento</translation>
    </message>
    <message>
        <source>Smallest stretch</source>
        <translation>Menor estiramento</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeza</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Mapa de cores</translation>
    </message>
    <message>
        <source>Colour map; all are safe for colour-blind readers.</source>
        <translation>Mapa de cores; todos são seguros para daltônicos.</translation>
    </message>
    <message>
        <source>Stretch map</source>
        <translation>Mapa de estiramento</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Save the map or its numbers</source>
        <translation>Salva o mapa ou seus números</translation>
    </message>
    <message>
        <source>Picture (PNG)…</source>
        <translation>Imagem (PNG)…</translation>
    </message>
    <message>
        <source>Table (CSV)…</source>
        <translation>Tabela (CSV)…</translation>
    </message>
    <message>
        <source>Film (VTP)…</source>
        <translation>Película (VTP)…</translation>
    </message>
    <message>
        <source>Run the dip to see how the film stretches.</source>
        <translation>Execute a imersão para ver como a película estica.</translation>
    </message>
    <message>
        <source>What the map shows.</source>
        <translation>O que o mapa mostra.</translation>
    </message>
    <message>
        <source>Shows all film over the limit in one warning colour.</source>
        <translation>Mostra toda a película acima do limite em uma cor de aviso.</translation>
    </message>
    <message>
        <source>Lines of equal value on the map.</source>
        <translation>Linhas de mesmo valor no mapa.</translation>
    </message>
    <message>
        <source>On the part: mean %1 · 95 % below %2 · largest %3</source>
        <translation>Na peça: média %1 · 95 % abaixo de %2 · maior %3</translation>
    </message>
    <message>
        <source>Length after the dip divided by length before it, averaged over the directions around each point.</source>
        <translation>Comprimento depois da imersão dividido pelo comprimento antes dela, em média sobre as direções em volta de cada ponto.</translation>
    </message>
    <message>
        <source>Area after the dip divided by area before it. The ink thins by this factor.</source>
        <translation>Área depois da imersão dividida pela área antes dela. A tinta afina por este fator.</translation>
    </message>
    <message>
        <source>The stretch in the direction in which the film is stretched most.</source>
        <translation>O estiramento na direção em que a película mais estica.</translation>
    </message>
    <message>
        <source>The stretch in the direction in which the film is stretched least. Below 1, the film wrinkles.</source>
        <translation>O estiramento na direção em que a película menos estica. Abaixo de 1 a película enruga.</translation>
    </message>
    <message>
        <source>Fits the colours to the values on the part. If off, the scale runs between the two numbers on the right, so that you can compare maps.</source>
        <translation>Ajusta as cores aos valores na peça. Se desligado, a escala vai de um ao outro dos dois números à direita, para comparar mapas.</translation>
    </message>
</context>
<context>
    <name>dipwright::SurfaceQuery</name>
    <message>
        <source>The mesh is too large for this computer&apos;s memory; reduce its number of triangles</source>
        <translation>A malha é grande demais para a memória deste computador; reduza o número de triângulos</translation>
    </message>
</context>
<context>
    <name>dipwright::TankController</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The project has changed since these sheets were made.</source>
        <translation>O projeto mudou desde que estas folhas foram feitas.</translation>
    </message>
    <message>
        <source>Keep times at the tank</source>
        <translation>Guardar tempos no tanque</translation>
    </message>
    <message>
        <source>The times of %1 were not stored: the project is closed and has no file</source>
        <translation>Os tempos de %1 não foram guardados: o projeto está fechado e não tem arquivo</translation>
    </message>
    <message>
        <source>Storing the times</source>
        <translation>Guardando os tempos</translation>
    </message>
    <message>
        <source>The times of %1 were not stored</source>
        <translation>Os tempos de %1 não foram guardados</translation>
    </message>
</context>
<context>
    <name>dipwright::TankPage</name>
    <message>
        <source>Done (space bar)</source>
        <translation>Pronto (barra de espaço)</translation>
    </message>
    <message>
        <source>Ends this step and stores its time; space bar</source>
        <translation>Termina este passo e guarda o tempo; barra de espaço</translation>
    </message>
    <message>
        <source>Back (←)</source>
        <translation>Voltar (←)</translation>
    </message>
    <message>
        <source>Returns to the step before and forgets its time; left arrow</source>
        <translation>Volta ao passo anterior e esquece o tempo dele; seta para a esquerda</translation>
    </message>
    <message>
        <source>Pause (P)</source>
        <translation>Pausa (P)</translation>
    </message>
    <message>
        <source>Stops the clock until you continue; P</source>
        <translation>Para o relógio até você continuar; P</translation>
    </message>
    <message>
        <source>Sound (S)</source>
        <translation>Som (S)</translation>
    </message>
    <message>
        <source>Beeps in the last three seconds of a step; S</source>
        <translation>Apita nos três últimos segundos de um passo; S</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Fechar (Esc)</translation>
    </message>
    <message>
        <source>Closes the page. It continues at this step when it is opened again; Escape</source>
        <translation>Fecha a página. Ela continua neste passo quando for aberta de novo; Esc</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>No tanque</translation>
    </message>
    <message>
        <source>Time of the step</source>
        <translation>Tempo do passo</translation>
    </message>
    <message>
        <source>job %1 of %2</source>
        <translation>trabalho %1 de %2</translation>
    </message>
    <message>
        <source>dip %1</source>
        <translation>imersão %1</translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation>passo %1 de %2</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>vez %1</translation>
    </message>
    <message>
        <source>All steps are done</source>
        <translation>Todos os passos estão prontos</translation>
    </message>
    <message>
        <source>Paused: %1</source>
        <translation>Pausa: %1</translation>
    </message>
    <message>
        <source>The times are stored with the job. The space bar starts the next run.</source>
        <translation>Os tempos foram guardados com o trabalho. A barra de espaço começa a próxima vez.</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Depois: %1</translation>
    </message>
    <message>
        <source>Next run (space bar)</source>
        <translation>Próxima vez (barra de espaço)</translation>
    </message>
    <message>
        <source>Continue (P)</source>
        <translation>Continuar (P)</translation>
    </message>
</context>
<context>
    <name>dipwright::Texture</name>
    <message>
        <source>The picture has no pixels; choose another one</source>
        <translation>A imagem não tem pixels; escolha outra</translation>
    </message>
    <message>
        <source>The file is not a picture that can be read; save it as PNG or JPEG</source>
        <translation>O arquivo não é uma imagem legível; salve-a como PNG ou JPEG</translation>
    </message>
    <message>
        <source>%1, with %2 × %3 pixels</source>
        <translation>%1, com %2 × %3 pixels</translation>
    </message>
    <message>
        <source>The photo is incomplete; copy it from the camera again</source>
        <translation>A foto está incompleta; copie-a de novo da câmera</translation>
    </message>
    <message>
        <source>HEIF pictures cannot be read on this computer; save the picture as JPEG, or set the camera to JPEG</source>
        <translation>Imagens HEIF não podem ser lidas neste computador; salve a imagem como JPEG ou ajuste a câmera para JPEG</translation>
    </message>
    <message>
        <source>The picture is damaged: its ICC profile is incomplete; save it again</source>
        <translation>A imagem está danificada: seu perfil ICC está incompleto; salve-a de novo</translation>
    </message>
    <message>
        <source>The picture&apos;s ICC profile is damaged or does not match its pixels; save the picture again as sRGB</source>
        <translation>O perfil ICC da imagem está danificado ou não corresponde aos seus pixels; salve a imagem de novo como sRGB</translation>
    </message>
    <message>
        <source>The picture&apos;s ICC profile is larger than %1 MB; save the picture again as sRGB</source>
        <translation>O perfil ICC da imagem é maior que %1 MB; salve a imagem de novo como sRGB</translation>
    </message>
    <message>
        <source>The picture file is incomplete; save it again, or copy it again from its source</source>
        <translation>O arquivo da imagem está incompleto; salve-o de novo ou copie-o outra vez da origem</translation>
    </message>
    <message>
        <source>The CMYK picture is damaged or stored in an unsupported way; save it again as JPEG, or as TIFF without tiles or planes</source>
        <translation>A imagem CMYK está danificada ou gravada de um modo não suportado; salve-a de novo como JPEG, ou como TIFF sem blocos nem planos</translation>
    </message>
    <message>
        <source>The picture is damaged: %1; save it again</source>
        <translation>A imagem está danificada: %1; salve-a de novo</translation>
    </message>
    <message>
        <source>The Lab picture is damaged or stored in an unsupported way; save it again as RGB, or as TIFF in 8 or 16 bits without tiles or planes</source>
        <translation>A imagem Lab está danificada ou gravada de um modo não suportado; salve-a de novo como RGB, ou como TIFF em 8 ou 16 bits sem blocos nem planos</translation>
    </message>
    <message>
        <source>The TIFF file stores its pixels in a way that is not supported, such as in planes, as floating-point numbers or with extra channels; save the picture again as PNG, or as TIFF with 8 or 16 bits, without planes and extra channels</source>
        <translation>O arquivo TIFF grava seus pixels de um modo não suportado, como em planos, como números de ponto flutuante ou com canais adicionais; salve a imagem de novo como PNG, ou como TIFF com 8 ou 16 bits, sem planos nem canais adicionais</translation>
    </message>
    <message>
        <source>The CMYK picture has 16 bits and no ICC profile; save it with its profile, with 8 bits, or as sRGB</source>
        <translation>A imagem CMYK tem 16 bits e nenhum perfil ICC; salve-a com seu perfil, com 8 bits ou como sRGB</translation>
    </message>
</context>
<context>
    <name>dipwright::TexturedMesh</name>
    <message>
        <source>The model&apos;s texture</source>
        <translation>A textura do modelo</translation>
    </message>
    <message>
        <source>Texture %1 of the model</source>
        <translation>Textura %1 do modelo</translation>
    </message>
</context>
<context>
    <name>dipwright::TimeLeft</name>
    <message>
        <source>about %1 s left</source>
        <translation>restam cerca de %1 s</translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation>restam cerca de %1 min</translation>
    </message>
    <message>
        <source>about %1 h %2 min left</source>
        <translation>restam cerca de %1 h %2 min</translation>
    </message>
</context>
<context>
    <name>dipwright::Timeline</name>
    <message>
        <source>Before the dip</source>
        <translation>Antes da imersão</translation>
    </message>
    <message>
        <source>Play the dip</source>
        <translation>Reproduz a imersão</translation>
    </message>
    <message>
        <source>End of the dip</source>
        <translation>Fim da imersão</translation>
    </message>
    <message>
        <source>Time of the dip</source>
        <translation>Tempo da imersão</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Depth of the part&apos;s lowest point below the waterline</source>
        <translation>Profundidade do ponto mais baixo da peça abaixo da linha d&apos;água</translation>
    </message>
</context>
<context>
    <name>dipwright::ToleranceCheck</name>
    <message>
        <source>Tolerances</source>
        <translation>Tolerâncias</translation>
    </message>
    <message>
        <source>Computing the tolerances</source>
        <translation>Calculando as tolerâncias</translation>
    </message>
</context>
<context>
    <name>dipwright::ToleranceDialog</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Tolerance of the sheet</source>
        <translation>Tolerância da folha</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Números</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerâncias</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerância</translation>
    </message>
    <message>
        <source>Contribution</source>
        <translation>Contribuição</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Effect of each contributor</source>
        <translation>Efeito de cada desvio</translation>
    </message>
    <message>
        <source>How much this contributor adds to the total displacement of the image</source>
        <translation>Quanto este desvio contribui para o deslocamento total da imagem</translation>
    </message>
    <message>
        <source>The project has changed since these figures were computed.</source>
        <translation>O projeto mudou desde que estes números foram calculados.</translation>
    </message>
    <message>
        <source>How far this quantity may deviate, up or down</source>
        <translation>Quanto esta grandeza pode desviar, para mais ou para menos</translation>
    </message>
    <message>
        <source>With this contributor alone, half of the painted area lands within this distance of its intended place</source>
        <translation>Só com este desvio, metade da área pintada fica a menos desta distância do lugar previsto</translation>
    </message>
    <message>
        <source>With this contributor alone, 95 % of the painted area lands within this distance of its intended place</source>
        <translation>Só com este desvio, 95 % da área pintada fica a menos desta distância do lugar previsto</translation>
    </message>
    <message>
        <source>With this contributor alone, the largest displacement on the part</source>
        <translation>Só com este desvio, o maior deslocamento na peça</translation>
    </message>
    <message>
        <source>With this contributor alone, the area at the edge of the paint that is no longer painted (−) or painted in addition (+)</source>
        <translation>Só com este desvio, a área na borda da pintura que deixa de ser pintada (−) ou é pintada a mais (+)</translation>
    </message>
    <message>
        <source>All contributors together: 95 % of the painted area is within %1 of its intended place, and half of the area within %2.</source>
        <translation>Todos os desvios juntos: 95 % da área pintada fica a menos de %1 do lugar previsto, e metade da área a menos de %2.</translation>
    </message>
    <message>
        <source>Displacement of %1 at the place %2 on the model; largest contributor: %3</source>
        <translation>Deslocamento de %1 no ponto %2 do modelo; maior contribuição: %3</translation>
    </message>
</context>
<context>
    <name>dipwright::Tour</name>
    <message>
        <source>Back</source>
        <translation>Voltar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Concluir</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Avançar</translation>
    </message>
</context>
<context>
    <name>dipwright::VerdictPanel</name>
    <message>
        <source>Verdict</source>
        <translation>Veredito</translation>
    </message>
    <message>
        <source>Numerical error of the sheet</source>
        <translation>Erro numérico da folha</translation>
    </message>
    <message>
        <source>Run the dip to see the numerical error of the sheet.</source>
        <translation>Execute a imersão para ver o erro numérico da folha.</translation>
    </message>
    <message>
        <source>This is a draft. The verdict follows with the result.</source>
        <translation>Este é um rascunho. O veredito vem com o resultado.</translation>
    </message>
    <message>
        <source>This is a draft. There is no verdict, because the run was cancelled. Run the dip to get one.</source>
        <translation>Este é um rascunho. Não há veredito, porque a execução foi cancelada. Execute a imersão para obter um.</translation>
    </message>
    <message>
        <source>This is a draft. There is no verdict, because the run failed. See the log for the reason, then run the dip again.</source>
        <translation>Este é um rascunho. Não há veredito, porque a execução falhou. Veja o motivo no registro e depois execute a imersão de novo.</translation>
    </message>
</context>
<context>
    <name>dipwright::ViewController</name>
    <message>
        <source>Reading the picture</source>
        <translation>Lendo a imagem</translation>
    </message>
    <message>
        <source>Picture on the film</source>
        <translation>Imagem na película</translation>
    </message>
</context>
<context>
    <name>dipwright::WatchPage</name>
    <message>
        <source>Date %1   Lot %2   Water %3 °C</source>
        <translation>Data %1   Lote %2   Água %3 °C</translation>
    </message>
    <message>
        <source>Film watch: print this page on the film</source>
        <translation>Medição da película: imprima esta página na película</translation>
    </message>
    <message>
        <source>Film watch, card: print this page on stiff, waterproof cardboard</source>
        <translation>Medição da película, cartão: imprima esta página em papel-cartão rígido e impermeável</translation>
    </message>
    <message>
        <source>Ink side: lay the film on the water with this side up, so that you can read this text from above.</source>
        <translation>Lado da tinta: ponha a película na água com este lado para cima, com este texto legível de cima.</translation>
    </message>
    <message>
        <source>For every photo, lay the card flat on the water beside the film, with this side up.</source>
        <translation>Para cada foto, ponha o cartão deitado na água ao lado da película, com este lado para cima.</translation>
    </message>
    <message>
        <source>Both rulers must measure %1 mm. If they do not, enter their measured lengths when you evaluate the photos.</source>
        <translation>As duas réguas devem medir %1 mm. Se não, informe os comprimentos medidos ao avaliar as fotos.</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small for a chessboard with %3 corners; use larger paper</source>
        <translation>Papel de %1 × %2 mm é pequeno demais para um tabuleiro com %3 cantos; use papel maior</translation>
    </message>
</context>
<context>
    <name>dipwright::WedgePage</name>
    <message>
        <source>1. Zero the densitometer on unprinted film. Read every patch before the dip.</source>
        <translation>1. Zere o densitômetro em película sem impressão. Leia cada amostra antes da imersão.</translation>
    </message>
    <message>
        <source>Date %1   Lot %2</source>
        <translation>Data %1   Lote %2</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small for the wedge; use larger paper</source>
        <translation>Papel de %1 × %2 mm é pequeno demais para a cunha; use papel maior</translation>
    </message>
    <message>
        <source>Step wedge: print this page on the film like a sheet</source>
        <translation>Cunha de tons: imprima esta página na película como uma folha</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densidade</translation>
    </message>
    <message>
        <source>2. Stretch the floating film by a dip or by hand. Measure both rulers (%1 mm if not stretched).</source>
        <translation>2. Estire a película flutuando, por imersão ou à mão. Meça as duas réguas (%1 mm sem estiramento).</translation>
    </message>
    <message>
        <source>3. Read every patch again. Repeat with 3 or 4 stretches, up to the largest stretch of the job.</source>
        <translation>3. Leia cada amostra de novo. Repita com 3 ou 4 estiramentos, até o maior estiramento do trabalho.</translation>
    </message>
</context>
<context>
    <name>dipwright::WedgeTable</name>
    <message>
        <source>The table of a step wedge must begin with the line %1 and have at most %2 lines</source>
        <translation>A tabela de uma cunha de tons deve começar com a linha %1 e ter no máximo %2 linhas</translation>
    </message>
    <message>
        <source>Line %1 of the table must contain an ink (cyan, magenta, yellow, black, white or grey) and five numbers, separated by commas</source>
        <translation>A linha %1 da tabela deve conter uma tinta (cyan, magenta, yellow, black, white ou grey) e cinco números, separados por vírgulas</translation>
    </message>
</context>
<context>
    <name>dipwright::WeightFields</name>
    <message>
        <source>Quality in zone %1</source>
        <translation>Qualidade na zona %1</translation>
    </message>
    <message>
        <source>Weight of %1</source>
        <translation>Peso de %1</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>Limite de %1</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>How much more the quality counts in this zone of the part. Zones are marked under Tolerances.</source>
        <translation>Quanto mais a qualidade conta nesta zona da peça. As zonas são marcadas em Tolerâncias.</translation>
    </message>
    <message>
        <source>How much this measure counts, compared with the others. 0: not at all.</source>
        <translation>Quanto esta medida conta em relação às outras. 0: nada.</translation>
    </message>
    <message>
        <source>Of poses with the same verdict, those that miss this limit rank below those that keep it.</source>
        <translation>Entre poses com o mesmo veredito, as que não cumprem este limite ficam depois das que o cumprem.</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowActions</name>
    <message>
        <source>Open another window</source>
        <translation>Abre outra janela</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Abre um projeto</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salvar</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Salva o projeto</translation>
    </message>
    <message>
        <source>Save the project as another file</source>
        <translation>Salva o projeto em outro arquivo</translation>
    </message>
    <message>
        <source>Write sheets, stretch maps, proof, films and report to a folder</source>
        <translation>Grava folhas, mapas de estiramento, prova, películas e relatório em uma pasta</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Im&amp;primir…</translation>
    </message>
    <message>
        <source>Pro&amp;files…</source>
        <translation>Per&amp;fis…</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Fecha esta janela</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Sa&amp;ir</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Fecha todas as janelas</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Desfazer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Refazer</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Preferências…</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;xecutar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Enquadrar</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>&amp;Oblíqua</translation>
    </message>
    <message>
        <source>Look from above at an angle</source>
        <translation>Olha de cima em ângulo</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Frente</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Olha de frente</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>&amp;Direita</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Olha da direita</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Em c&amp;ima</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Olha de cima</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>&amp;Trás</translation>
    </message>
    <message>
        <source>Look from behind</source>
        <translation>Olha de trás</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Es&amp;querda</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Olha da esquerda</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>Embai&amp;xo</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Olha de baixo</translation>
    </message>
    <message>
        <source>Show the water and the edges of the tank</source>
        <translation>Mostra a água e as bordas do tanque</translation>
    </message>
    <message>
        <source>At the end of the dip, hide the film that paints nothing</source>
        <translation>No fim da imersão, esconde a película que não pinta nada</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>&amp;Lines every 10 mm</source>
        <translation>&amp;Linhas a cada 10 mm</translation>
    </message>
    <message>
        <source>S&amp;tretch</source>
        <translation>&amp;Estiramento</translation>
    </message>
    <message>
        <source>&amp;About Dipwright</source>
        <translation>&amp;Sobre o Dipwright</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <translation>&amp;Desfazer “%1”</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <translation>&amp;Refazer “%1”</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Tolerances…</source>
        <translation>&amp;Tolerâncias…</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>&amp;Corte</translation>
    </message>
    <message>
        <source>Snapsho&amp;ts…</source>
        <translation>Instan&amp;tâneos…</translation>
    </message>
    <message>
        <source>Turn about &amp;X by 15°</source>
        <translation>Girar 15° em torno de &amp;X</translation>
    </message>
    <message>
        <source>Turn about X by −15°</source>
        <translation>Girar −15° em torno de X</translation>
    </message>
    <message>
        <source>Turn about &amp;Y by 15°</source>
        <translation>Girar 15° em torno de &amp;Y</translation>
    </message>
    <message>
        <source>Turn about Y by −15°</source>
        <translation>Girar −15° em torno de Y</translation>
    </message>
    <message>
        <source>Turn about &amp;Z by 15°</source>
        <translation>Girar 15° em torno de &amp;Z</translation>
    </message>
    <message>
        <source>Turn about Z by −15°</source>
        <translation>Girar −15° em torno de Z</translation>
    </message>
    <message>
        <source>&amp;Artwork</source>
        <translation>Art&amp;e</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Nova &amp;janela</translation>
    </message>
    <message>
        <source>&amp;New project…</source>
        <translation>&amp;Novo projeto…</translation>
    </message>
    <message>
        <source>Create a project from a model</source>
        <translation>Cria um projeto a partir de um modelo</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salvar &amp;como…</translation>
    </message>
    <message>
        <source>Save the settings under a name, compare them and restore them</source>
        <translation>Salva as configurações com um nome, compara e restaura</translation>
    </message>
    <message>
        <source>&amp;Export results…</source>
        <translation>&amp;Exportar resultados…</translation>
    </message>
    <message>
        <source>Export sheet as P&amp;DF…</source>
        <translation>Exportar folha em P&amp;DF…</translation>
    </message>
    <message>
        <source>Save the sheet of this dip as PDF at true size</source>
        <translation>Salva a folha desta imersão em PDF no tamanho real</translation>
    </message>
    <message>
        <source>Export film image as PN&amp;G…</source>
        <translation>Exportar imagem da película em PN&amp;G…</translation>
    </message>
    <message>
        <source>Save the film image of this dip as PNG</source>
        <translation>Salva a imagem da película desta imersão em PNG</translation>
    </message>
    <message>
        <source>Export crad&amp;les…</source>
        <translation>Exportar berç&amp;os…</translation>
    </message>
    <message>
        <source>Save a cradle that holds the part in each dip, as STL and 3MF for 3D printing</source>
        <translation>Salva um berço que segura a peça em cada imersão, em STL e 3MF para impressão 3D</translation>
    </message>
    <message>
        <source>Print the sheets at true size</source>
        <translation>Imprime as folhas no tamanho real</translation>
    </message>
    <message>
        <source>Print &amp;history…</source>
        <translation>&amp;Histórico de impressão…</translation>
    </message>
    <message>
        <source>Show what was printed, when, on which printer and from which project</source>
        <translation>Mostra o que foi impresso, quando, em qual impressora e de qual projeto</translation>
    </message>
    <message>
        <source>&amp;Job queue…</source>
        <translation>&amp;Fila de trabalhos…</translation>
    </message>
    <message>
        <source>Run several projects one after the other while you keep working</source>
        <translation>Executa vários projetos um após o outro enquanto você continua trabalhando</translation>
    </message>
    <message>
        <source>Several jobs on one &amp;film…</source>
        <translation>&amp;Vários trabalhos em uma película…</translation>
    </message>
    <message>
        <source>Place the sheets of several projects, and copies of them, side by side on a film or roll</source>
        <translation>Coloca as folhas de vários projetos, e cópias delas, lado a lado em uma película ou rolo</translation>
    </message>
    <message>
        <source>Calibrate pr&amp;inter…</source>
        <translation>Cali&amp;brar impressora…</translation>
    </message>
    <message>
        <source>Print a page with rulers and store the printer&apos;s scale in its profile</source>
        <translation>Imprime uma página com réguas e guarda a escala da impressora no perfil dela</translation>
    </message>
    <message>
        <source>Show and edit the profiles of printers, films and tanks</source>
        <translation>Mostra e edita os perfis de impressoras, películas e tanques</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>Fechar jane&amp;la</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Desfaz a última mudança</translation>
    </message>
    <message>
        <source>Redo the change that was undone</source>
        <translation>Refaz a mudança desfeita</translation>
    </message>
    <message>
        <source>Add &amp;second dip</source>
        <translation>Adicionar &amp;segunda imersão</translation>
    </message>
    <message>
        <source>Dip the part a second time, from another side</source>
        <translation>Mergulha a peça uma segunda vez, de outro lado</translation>
    </message>
    <message>
        <source>Remove &amp;dip</source>
        <translation>Remover &amp;imersão</translation>
    </message>
    <message>
        <source>Remove the dip that is shown</source>
        <translation>Remove a imersão mostrada</translation>
    </message>
    <message>
        <source>S&amp;wap dips</source>
        <translation>Tro&amp;car imersões</translation>
    </message>
    <message>
        <source>Re&amp;load model</source>
        <translation>Recarregar mode&amp;lo</translation>
    </message>
    <message>
        <source>Read the model file again and keep all settings</source>
        <translation>Lê de novo o arquivo do modelo e mantém todas as configurações</translation>
    </message>
    <message>
        <source>Replace &amp;model…</source>
        <translation>Trocar &amp;modelo…</translation>
    </message>
    <message>
        <source>Use another model</source>
        <translation>Usa outro modelo</translation>
    </message>
    <message>
        <source>Replace &amp;texture…</source>
        <translation>Trocar &amp;textura…</translation>
    </message>
    <message>
        <source>Use another image as the texture</source>
        <translation>Usa outra imagem como textura</translation>
    </message>
    <message>
        <source>Place pictures, text and patterns on the part</source>
        <translation>Põe imagens, texto e padrões sobre a peça</translation>
    </message>
    <message>
        <source>Set units, language, theme, shortcuts and solvers</source>
        <translation>Define unidades, idioma, aparência, atalhos e solucionadores</translation>
    </message>
    <message>
        <source>Simulate the dip and compute the sheets</source>
        <translation>Simula a imersão e calcula as folhas</translation>
    </message>
    <message>
        <source>Cancel everything that is running</source>
        <translation>Cancela tudo o que está em execução</translation>
    </message>
    <message>
        <source>Run &amp;live</source>
        <translation>Executar ao &amp;vivo</translation>
    </message>
    <message>
        <source>&amp;Find poses…</source>
        <translation>&amp;Procurar poses…</translation>
    </message>
    <message>
        <source>Search for the best rotation and position of the part, for one dip or two</source>
        <translation>Procura a melhor rotação e posição da peça, para uma ou duas imersões</translation>
    </message>
    <message>
        <source>Check numerical &amp;error…</source>
        <translation>Verificar &amp;erro numérico…</translation>
    </message>
    <message>
        <source>Compute how far handling may move the image, and which zones keep their limits</source>
        <translation>Calcula quanto o manuseio pode deslocar a imagem e que zonas respeitam seus limites</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Reproduzir ou pausar</translation>
    </message>
    <message>
        <source>Show all of the part and the film</source>
        <translation>Mostra toda a peça e toda a película</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Redefinir disposição</translation>
    </message>
    <message>
        <source>Put all panels back into their original places</source>
        <translation>Põe todos os painéis de volta em seus lugares originais</translation>
    </message>
    <message>
        <source>&amp;Save layout…</source>
        <translation>&amp;Salvar disposição…</translation>
    </message>
    <message>
        <source>Save the arrangement of the panels under a name</source>
        <translation>Salva a disposição dos painéis com um nome</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>Projeção parale&amp;la</translation>
    </message>
    <message>
        <source>Rings an&amp;d arrows</source>
        <translation>A&amp;néis e setas</translation>
    </message>
    <message>
        <source>Show the rings that turn the part and the arrows that move it</source>
        <translation>Mostra os anéis que giram a peça e as setas que a movem</translation>
    </message>
    <message>
        <source>&amp;Water and tank</source>
        <translation>Á&amp;gua e tanque</translation>
    </message>
    <message>
        <source>P&amp;art</source>
        <translation>&amp;Peça</translation>
    </message>
    <message>
        <source>Show the part</source>
        <translation>Mostra a peça</translation>
    </message>
    <message>
        <source>Co&amp;verage on the part</source>
        <translation>Co&amp;bertura na peça</translation>
    </message>
    <message>
        <source>Show the painted area of the part</source>
        <translation>Mostra a área pintada da peça</translation>
    </message>
    <message>
        <source>F&amp;inished part</source>
        <translation>Peça p&amp;ronta</translation>
    </message>
    <message>
        <source>Show the part as it comes out of all dips, from every side</source>
        <translation>Mostra a peça como sai de todas as imersões, de todos os lados</translation>
    </message>
    <message>
        <source>&amp;Zones on the part</source>
        <translation>&amp;Zonas na peça</translation>
    </message>
    <message>
        <source>Film on the part o&amp;nly</source>
        <translation>&amp;Só a película na peça</translation>
    </message>
    <message>
        <source>S&amp;ee-through film</source>
        <translation>Pelíc&amp;ula translúcida</translation>
    </message>
    <message>
        <source>Show the part through the film</source>
        <translation>Mostra a peça através da película</translation>
    </message>
    <message>
        <source>What the film shows in the 3D view</source>
        <translation>O que a película mostra na vista 3D</translation>
    </message>
    <message>
        <source>Film &amp;image</source>
        <translation>Imagem da &amp;película</translation>
    </message>
    <message>
        <source>&amp;Shares of the dips</source>
        <translation>Pa&amp;rtes das imersões</translation>
    </message>
    <message>
        <source>&amp;Chessboard, 17 mm squares</source>
        <translation>&amp;Xadrez, quadrados de 17 mm</translation>
    </message>
    <message>
        <source>&amp;Picture from file…</source>
        <translation>Imagem de &amp;arquivo…</translation>
    </message>
    <message>
        <source>Turn the part by 15°</source>
        <translation>Gira a peça 15°</translation>
    </message>
    <message>
        <source>Move the part over the film</source>
        <translation>Move a peça sobre a película</translation>
    </message>
    <message>
        <source>Move &amp;right by 5 mm</source>
        <translation>Mover 5 mm para a &amp;direita</translation>
    </message>
    <message>
        <source>Move &amp;left by 5 mm</source>
        <translation>Mover 5 mm para a &amp;esquerda</translation>
    </message>
    <message>
        <source>Move &amp;up the sheet by 5 mm</source>
        <translation>Mover 5 mm para &amp;cima na folha</translation>
    </message>
    <message>
        <source>Move &amp;down the sheet by 5 mm</source>
        <translation>Mover 5 mm para &amp;baixo na folha</translation>
    </message>
    <message>
        <source>Move to the &amp;middle of the film</source>
        <translation>Mover para o &amp;meio da película</translation>
    </message>
    <message>
        <source>Quick &amp;tour</source>
        <translation>&amp;Visita rápida</translation>
    </message>
    <message>
        <source>User &amp;guide</source>
        <translation>&amp;Guia do usuário</translation>
    </message>
    <message>
        <source>&amp;What is this?</source>
        <translation>O &amp;que é isto?</translation>
    </message>
    <message>
        <source>Click an element of the window to see what it does</source>
        <translation>Clique em um elemento da janela para ver o que ele faz</translation>
    </message>
    <message>
        <source>Film on the part before the d&amp;ip</source>
        <translation>Película na peça antes da &amp;imersão</translation>
    </message>
    <message>
        <source>Draw near and far places at the same scale, without perspective</source>
        <translation>Desenha lugares próximos e distantes na mesma escala, sem perspectiva</translation>
    </message>
    <message>
        <source>Exchange the order of the two dips</source>
        <translation>Inverte a ordem das duas imersões</translation>
    </message>
    <message>
        <source>As soon as there is a first result, run again after each change</source>
        <translation>Depois do primeiro resultado, executa de novo após cada mudança</translation>
    </message>
    <message>
        <source>Compute the sheets with finer steps and cells, and show where and how far the image changes</source>
        <translation>Calcula as folhas com passos e células mais finos e mostra onde e quanto a imagem muda</translation>
    </message>
    <message>
        <source>Play the dip, or pause it</source>
        <translation>Reproduz ou pausa a imersão</translation>
    </message>
    <message>
        <source>While you place the part, show it with the film of the last results; if this is off, show the flat film</source>
        <translation>Ao posicionar a peça, mostra-a com a película dos últimos resultados; se desativado, mostra a película plana</translation>
    </message>
    <message>
        <source>Cut the part and the film open along a plane; move the plane with its slider or its frame</source>
        <translation>Abre a peça e a película ao longo de um plano; mova o plano com o controle ou com a moldura</translation>
    </message>
    <message>
        <source>Explain the areas of the window in six steps</source>
        <translation>Explica as áreas da janela em seis passos</translation>
    </message>
    <message>
        <source>Open the user guide at the section about the selected field</source>
        <translation>Abre o guia no trecho sobre o campo selecionado</translation>
    </message>
    <message>
        <source>Show the zones of the part. After Dip ▸ Tolerances, also show where the zones stay within their limits</source>
        <translation>Mostra as zonas da peça. Depois de Imersão ▸ Tolerâncias, mostra também onde as zonas ficam dentro dos seus limites</translation>
    </message>
    <message>
        <source>&amp;Zoom to part</source>
        <translation>&amp;Zoom na peça</translation>
    </message>
    <message>
        <source>Show the part as large as possible, without the film around it</source>
        <translation>Mostra a peça no maior tamanho possível, sem a película ao redor</translation>
    </message>
    <message>
        <source>Make &amp;outputs…</source>
        <translation>Gerar saí&amp;das…</translation>
    </message>
    <message>
        <source>Write a list of files that is kept with the project, such as everything that the print shop needs</source>
        <translation>Gravar uma lista de arquivos guardada no projeto, por exemplo tudo o que a gráfica precisa</translation>
    </message>
    <message>
        <source>At the tan&amp;k…</source>
        <translation>No tan&amp;que…</translation>
    </message>
    <message>
        <source>Show the steps at the tank in large letters, count their times down and store how long they took</source>
        <translation>Mostrar os passos no tanque em letras grandes, contar seus tempos para trás e guardar quanto levaram</translation>
    </message>
    <message>
        <source>Warnings on t&amp;he part</source>
        <translation>Avisos na peç&amp;a</translation>
    </message>
    <message>
        <source>Mark trapped air, torn film and places that are not reached. Click a mark to see it in the report</source>
        <translation>Marcar ar preso, película rasgada e lugares não alcançados. Clique em uma marca para vê-la no relatório</translation>
    </message>
    <message>
        <source>Cradle aro&amp;und the part</source>
        <translation>Berço em to&amp;rno da peça</translation>
    </message>
    <message>
        <source>Make the cradle of this dip and show it, before you export it</source>
        <translation>Fazer o berço desta imersão e mostrá-lo antes de exportá-lo</translation>
    </message>
    <message>
        <source>Click two places on the part to measure the straight distance between them, and the distance along the surface</source>
        <translation>Clique em dois pontos da peça para medir a distância em linha reta e ao longo da superfície</translation>
    </message>
    <message>
        <source>Plates…</source>
        <translation>Chapas…</translation>
    </message>
    <message>
        <source>Show the plates of the sheets, the ink under the cursor, and where there is too much ink</source>
        <translation>Mostra as chapas das folhas, a tinta sob o cursor e onde há tinta demais</translation>
    </message>
    <message>
        <source>Send to ser&amp;ver…</source>
        <translation>Enviar ao ser&amp;vidor…</translation>
    </message>
    <message>
        <source>Simulate the dips on another computer, such as one with a GPU, and show the results here</source>
        <translation>Simula as imersões em outro computador, como um com GPU, e mostra os resultados aqui</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowLayout</name>
    <message>
        <source>3D view of the dip</source>
        <translation>Vista 3D da imersão</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation>Nome da disposição</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remover</translation>
    </message>
    <message>
        <source>The part above the film. Drag to turn the view, drag with the right button to move it, use the wheel to zoom. Drag a ring to turn the part.</source>
        <translation>A peça acima da película. Arraste para girar a vista, com o botão direito para movê-la, use a roda para o zoom. Arraste um anel para girar a peça.</translation>
    </message>
    <message>
        <source>Save layout</source>
        <translation>Salvar disposição</translation>
    </message>
    <message>
        <source>No saved layouts</source>
        <translation>Nenhuma disposição salva</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arquivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Dip</source>
        <translation>&amp;Imersão</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Janela</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aj&amp;uda</translation>
    </message>
    <message>
        <source>&amp;Layouts</source>
        <translation>&amp;Disposições</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Principal</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Film appearance</source>
        <translation>Aparência da película</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;recente</translation>
    </message>
    <message>
        <source>Tur&amp;n part</source>
        <translation>&amp;Girar peça</translation>
    </message>
    <message>
        <source>Mo&amp;ve part</source>
        <translation>Mo&amp;ver peça</translation>
    </message>
    <message>
        <source>Film appearan&amp;ce</source>
        <translation>&amp;Aparência da película</translation>
    </message>
    <message>
        <source>What the film shows in the 3D view</source>
        <translation>O que a película mostra na vista 3D</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowMessages</name>
    <message>
        <source>Read files</source>
        <translation>Ler arquivos</translation>
    </message>
    <message>
        <source>Read these files only if they belong to the model or project. A model or project from someone else may refer to your private files. These files would then be saved in the project.</source>
        <translation>Leia estes arquivos apenas se pertencerem ao modelo ou projeto. Um modelo ou projeto de outra pessoa pode se referir a seus arquivos privados. Esses arquivos seriam então salvos no projeto.</translation>
    </message>
</context>
<context>
    <name>dipwright::Workbench</name>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Restore project</source>
        <translation>Restaurar projeto</translation>
    </message>
    <message>
        <source>Dipwright was not closed properly. “%1” has unsaved changes from %2.</source>
        <translation>O Dipwright não foi fechado corretamente. “%1” tem mudanças não salvas, de %2.</translation>
    </message>
    <message>
        <source>The project was never saved to a file.</source>
        <translation>O projeto nunca foi salvo em um arquivo.</translation>
    </message>
    <message>
        <source>The file %1 still holds the last saved version.</source>
        <translation>O arquivo %1 ainda contém a última versão salva.</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Descartar mudanças</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>Decidir depois</translation>
    </message>
</context>
<context>
    <name>dipwright::ZoneFields</name>
    <message>
        <source>Marks zone %1</source>
        <translation>Marca a zona %1</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Extensão</translation>
    </message>
    <message>
        <source>Whole face</source>
        <translation>Face inteira</translation>
    </message>
    <message>
        <source>The zone that a click or drag on the part sets. Zone A must be painted most precisely. The surface without a mark is zone C.</source>
        <translation>A zona que um clique ou arrasto na peça define. A zona A deve ser pintada com mais exatidão. A superfície sem marca é a zona C.</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>What a click marks: the surface under the brush, the face up to its edges, or everything with the same material in the model.</source>
        <translation>O que um clique marca: a superfície sob o pincel, a face até as arestas ou tudo o que tem o mesmo material no modelo.</translation>
    </message>
    <message>
        <source>Whole material or CAD face</source>
        <translation>Material inteiro ou face CAD</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Computational hydrographic printing.</source>
        <translation>Impressão hidrográfica computacional.</translation>
    </message>
    <message>
        <source>Projects to open.</source>
        <translation>Projetos a abrir.</translation>
    </message>
</context>
</TS>
